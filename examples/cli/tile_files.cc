#include "examples/cli/tile_files.h"

#include <gable/engine/error.h>
#include <gable/engine/io/raster/point_cloud_raster.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_mosaic.h>
#include <gable/engine/io/raster/resample.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gable {
namespace {

namespace fs = std::filesystem;

CLI::Option* add_terrain_option(CLI::App* command, TileFileOptions* options) {
  return command
      ->add_option("--dtm", options->dtm,
                   "Terrain heights, on any grid of the same CRS; without it the terrain is "
                   "derived from the surface")
      ->type_name("FILE");
}

CLI::Option* add_crs_and_footprints(CLI::App* command, TileFileOptions* options) {
  command
      ->add_option("--crs", options->crs,
                   "Reference system of rasters that carry none, in projected metres: EPSG:27700")
      ->type_name("CRS");
  return command
      ->add_option("--footprints", options->footprints,
                   "Outlines (GeoPackage, shapefile, GeoJSON, ...): every polygon is one building; "
                   "without them buildings are found where the surface is 2 m above the terrain")
      ->type_name("FILE");
}

/// The rasters of a folder, by name.
std::vector<std::string> rasters_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::string extension = entry.path().extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".tif" || extension == ".tiff" || extension == ".asc" || extension == ".vrt") {
      files.push_back(entry.path().string());
    }
  }
  if (error) {
    throw Error(ExitCode::kNoInput,
                folder + ": cannot be read: " + error.message() + "; name a folder of terrain");
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::unique_ptr<HeightSource> open_rasters(const std::vector<std::string>& paths,
                                           const std::string& crs) {
  RasterFileOptions options;
  options.crs = crs;
  if (paths.size() == 1) return std::make_unique<RasterFile>(paths.front(), options);
  return std::make_unique<RasterMosaic>(paths, options);
}

}  // namespace

CLI::Option* add_tile_file_options(CLI::App* command, TileFileOptions* options) {
  command
      ->add_option("dsm", options->dsm,
                   "Surface heights: GeoTIFF, COG, ASC, VRT, ..., or points: LAS, LAZ")
      ->type_name("DSM")
      ->required();
  add_terrain_option(command, options);
  return add_crs_and_footprints(command, options);
}

CLI::Option* add_tile_set_options(CLI::App* command, TileFileOptions* options) {
  command
      ->add_option("dsm", options->tiles,
                   "Surface heights: GeoTIFF, COG, ASC, VRT, ..., or points: LAS, LAZ; several are "
                   "tiles side by side")
      ->type_name("DSM")
      ->required();
  CLI::Option* terrain = add_terrain_option(command, options);
  command
      ->add_option(
          "--dtm-dir", options->dtm_folder,
          "Folder of terrain tiles on one grid; where none reaches, the terrain is derived "
          "from the surface")
      ->type_name("DIR")
      ->excludes(terrain);
  command->add_option("--gsd", options->gsd, "Cells that points are turned into, metres")
      ->type_name("METRES")
      ->check(CLI::Range(0.05, 10.0))
      ->capture_default_str();
  return add_crs_and_footprints(command, options);
}

TileFiles::TileFiles(const TileFileOptions& options,
                     const std::function<void(const std::string&)>& say)
    : options_(options), say_(say) {
  open_surfaces();
  open_terrain();
  if (!options.footprints.empty()) footprints_ = read_polygons(options.footprints);
}

void TileFiles::open_surfaces() {
  const std::vector<std::string> paths = options_.surfaces();
  const auto num_clouds = std::count_if(paths.begin(), paths.end(), is_point_cloud);
  if (num_clouds == 0) {
    dsm_ = open_rasters(paths, options_.crs);
    return;
  }
  if (num_clouds < static_cast<std::ptrdiff_t>(paths.size())) {
    throw Error(ExitCode::kUsage, *std::find_if(paths.begin(), paths.end(), is_point_cloud) +
                                      ": points and rasters cannot be mixed; give either");
  }
  PointCloudRasterOptions cloud;
  cloud.gsd = options_.gsd;
  cloud.crs = options_.crs;
  cloud.scratch = options_.scratch;
  PointCloudRaster raster = rasterise_point_clouds(paths, cloud);
  say_(raster.dsm->path() + ": " + raster.used);
  dsm_ = std::move(raster.dsm);
  dtm_ = std::move(raster.dtm);
}

void TileFiles::open_terrain() {
  if (!options_.dtm.empty()) {
    terrain_files_ = {options_.dtm};
    dtm_ = open_rasters(terrain_files_, options_.crs);
    require_matching(*dsm_, *dtm_);
  } else if (!options_.dtm_folder.empty()) {
    RasterFileOptions raster;
    raster.crs = options_.crs;
    raster.may_be_empty = true;
    for (const std::string& path : rasters_in(options_.dtm_folder)) {
      if (overlap(RasterFile(path, raster).grid(), dsm_->grid())) terrain_files_.push_back(path);
    }
    if (!terrain_files_.empty()) {
      dtm_ = open_rasters(terrain_files_, options_.crs);
      require_matching(*dsm_, *dtm_);
    } else {
      say_(options_.dtm_folder + ": no terrain there reaches " + dsm_->path());
    }
  }
  if (!dtm_) say_(dsm_->path() + ": no --dtm, so the terrain is derived from the surface");
}

TileInput TileFiles::input() const {
  TileInput input;
  input.dsm = dsm_.get();
  input.dtm = dtm_.get();
  input.footprints = footprints_ ? &footprints_->footprints : nullptr;
  return input;
}

FootprintFile TileFiles::read_polygons(const std::string& path) const {
  FootprintFile file = read_footprints(path, dsm_->crs(), dsm_->grid());
  for (const std::string& line : file.skipped) say_(path + ": skipped " + line);
  for (const std::string& line : file.repaired) say_(path + ": repaired " + line);
  if (file.num_outside > 0) {
    say_(path + ": " + std::to_string(file.num_outside) + " footprints lie outside " +
         dsm_->path());
  }
  return file;
}

}  // namespace gable
