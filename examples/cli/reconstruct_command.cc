#include "examples/cli/reconstruct_command.h"

#include <gable/engine/error.h>
#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/raster_file.h>
#include <gable/engine/reconstruct/reconstruct_tile.h>

#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "examples/cli/model_outputs.h"
#include "examples/cli/progress.h"

namespace gable {
namespace {

struct ReconstructOptions {
  CommonOptions common;
  OutputOptions output;
  std::string dsm, dtm, footprints, filter, crs;
};

void say(const ReconstructOptions& options, const std::string& line) {
  if (!options.common.quiet) std::cerr << line << std::endl;
}

FootprintFile read_polygons(const std::string& path, const RasterFile& dsm,
                            const ReconstructOptions& options) {
  FootprintFile file = read_footprints(path, dsm.crs(), dsm.grid());
  for (const std::string& line : file.skipped) say(options, path + ": skipped " + line);
  for (const std::string& line : file.repaired) say(options, path + ": repaired " + line);
  if (file.num_outside > 0) {
    say(options,
        path + ": " + std::to_string(file.num_outside) + " footprints lie outside " + options.dsm);
  }
  return file;
}

void summarise(const TileSummary& summary, size_t num_extrusions,
               const ReconstructOptions& options) {
  std::string line = options.output.models + ": " + std::to_string(summary.num_buildings) +
                     " buildings, " + std::to_string(num_extrusions) + " of them extrusions";
  if (options.footprints.empty()) {
    line += "; left out: " + std::to_string(summary.num_small) + " small pieces, " +
            std::to_string(summary.num_crown) + " parts of trees";
    if (!options.filter.empty()) {
      line += ", " + std::to_string(summary.num_far) + " away from footprints";
    }
  }
  say(options, line);
}

void run(const ReconstructOptions& options, const CommandContext& context) {
  const RasterFile dsm(options.dsm, {options.crs});
  std::optional<RasterFile> dtm;
  if (!options.dtm.empty()) {
    dtm.emplace(options.dtm, RasterFileOptions{options.crs});
    require_matching(dsm, *dtm);
  } else {
    say(options, options.dsm + ": no --dtm, so the terrain is derived from the surface");
  }
  TileInput input{&dsm, dtm ? &*dtm : nullptr, nullptr, nullptr};
  FootprintFile footprints, filter;
  if (!options.footprints.empty()) {
    footprints = read_polygons(options.footprints, dsm, options);
    input.footprints = &footprints.footprints;
  }
  if (!options.filter.empty()) {
    filter = read_polygons(options.filter, dsm, options);
    input.filter = &filter.footprints;
  }

  ModelWriterOptions writer_options;
  writer_options.crs = dsm.crs();
  const Grid& grid = dsm.grid();
  writer_options.anchor << grid.center_of(grid.rows / 2, grid.cols / 2), 0.0;
  ModelOutputs outputs(options.output, writer_options);

  TileOptions tile_options;
  tile_options.threads = options.common.num_threads();
  std::unique_ptr<Progress> progress;
  size_t num_extrusions = 0;
  TileCallbacks callbacks;
  callbacks.begin_window = [&](int window, int num_windows, size_t num_buildings) {
    progress.reset();
    if (num_windows > 1) {
      say(options, "window " + std::to_string(window + 1) + " of " + std::to_string(num_windows));
    }
    progress = std::make_unique<Progress>("buildings", num_buildings,
                                          progress_style(options.common.quiet), std::cerr);
  };
  callbacks.inspect = [&](const TileBuilding& made) {
    outputs.draw(made.index, made.building, made.image);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    num_extrusions += made.building.status == BuildingStatus::kExtrusion;
    outputs.append(std::move(made.building), made.model);
    progress->advance();
  };
  const TileSummary summary = reconstruct_tile(input, tile_options, context.stop, callbacks);
  progress.reset();
  if (summary.stopped) throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  outputs.close();
  summarise(summary, num_extrusions, options);
}

}  // namespace

void add_reconstruct_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<ReconstructOptions>();
  CLI::App* command = app->add_subcommand(
      "reconstruct", "Make house models from surface heights (metres, projected, any cell size)");
  command->add_option("dsm", options->dsm, "Surface heights: GeoTIFF, COG, ASC, VRT, ...")
      ->type_name("DSM")
      ->required();
  command
      ->add_option("--dtm", options->dtm,
                   "Terrain heights, on any grid of the same CRS; without it the terrain is "
                   "derived from the surface")
      ->type_name("FILE");
  auto* footprints = command->add_option(
      "--footprints", options->footprints,
      "Outlines (GeoPackage, shapefile, GeoJSON, ...): every polygon is one building; without "
      "them buildings are found where the surface is 2 m above the terrain");
  footprints->type_name("FILE");
  command
      ->add_option("--near-footprints", options->filter,
                   "Find buildings in the heights, but keep only those inside an outline's "
                   "bounding box enlarged to twice its size")
      ->type_name("FILE")
      ->excludes(footprints);
  command
      ->add_option("--crs", options->crs,
                   "Reference system of rasters that carry none, in projected metres: EPSG:27700")
      ->type_name("CRS");
  add_output_options(command, &options->output);
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
