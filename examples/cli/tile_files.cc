#include "examples/cli/tile_files.h"

namespace gable {

CLI::Option* add_tile_file_options(CLI::App* command, TileFileOptions* options) {
  command->add_option("dsm", options->dsm, "Surface heights: GeoTIFF, COG, ASC, VRT, ...")
      ->type_name("DSM")
      ->required();
  command
      ->add_option("--dtm", options->dtm,
                   "Terrain heights, on any grid of the same CRS; without it the terrain is "
                   "derived from the surface")
      ->type_name("FILE");
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

TileFiles::TileFiles(const TileFileOptions& options,
                     const std::function<void(const std::string&)>& say)
    : options_(options), say_(say), dsm_(options.dsm, {options.crs}) {
  if (!options.dtm.empty()) {
    dtm_.emplace(options.dtm, RasterFileOptions{options.crs});
    require_matching(dsm_, *dtm_);
  } else {
    say_(options.dsm + ": no --dtm, so the terrain is derived from the surface");
  }
  if (!options.footprints.empty()) footprints_ = read_polygons(options.footprints);
}

TileInput TileFiles::input() const {
  TileInput input;
  input.dsm = &dsm_;
  input.dtm = dtm_ ? &*dtm_ : nullptr;
  input.footprints = footprints_ ? &footprints_->footprints : nullptr;
  return input;
}

FootprintFile TileFiles::read_polygons(const std::string& path) const {
  FootprintFile file = read_footprints(path, dsm_.crs(), dsm_.grid());
  for (const std::string& line : file.skipped) say_(path + ": skipped " + line);
  for (const std::string& line : file.repaired) say_(path + ": repaired " + line);
  if (file.num_outside > 0) {
    say_(path + ": " + std::to_string(file.num_outside) + " footprints lie outside " +
         options_.dsm);
  }
  return file;
}

}  // namespace gable
