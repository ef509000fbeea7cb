#include "examples/cli/refine_command.h"

#include <gable/engine/error.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/reconstruct/tile/refine_models.h>

#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "examples/cli/model_input.h"
#include "examples/cli/model_outputs.h"
#include "examples/cli/progress.h"
#include "examples/cli/spread_option.h"

namespace gable {
namespace {

struct RefineOptions {
  CommonOptions common;
  OutputOptions output;
  std::string dsm, dtm, init, crs;
  std::optional<double> spread;
};

void run(const RefineOptions& options, const CommandContext& context) {
  const RasterFile dsm(options.dsm, {options.crs});
  const RasterFile dtm(options.dtm, {options.crs});
  require_matching(dsm, dtm);
  const std::vector<Building> buildings = read_models(options.init, dsm);
  ModelWriterOptions writer_options;
  writer_options.crs = dsm.crs();
  const Grid& grid = dsm.grid();
  writer_options.anchor << grid.center_of(grid.rows / 2, grid.cols / 2), 0.0;
  ModelOutputs outputs(options.output, writer_options);

  RefineModelsOptions refine_options;
  refine_options.crop.spread = options.spread;
  refine_options.threads = options.common.num_threads();
  Progress progress("buildings", buildings.size(), progress_style(options.common.quiet), std::cerr);
  TileCallbacks callbacks;
  callbacks.inspect = [&](const TileBuilding& made) {
    outputs.draw(made.index, made.building, made.image);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    outputs.append(std::move(made.building), std::move(made.model));
    progress.advance();
  };
  if (!refine_models(dsm, dtm, buildings, refine_options, context.stop, callbacks)) {
    throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  }
  outputs.close();
}

}  // namespace

void add_refine_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<RefineOptions>();
  CLI::App* command =
      app->add_subcommand("refine", "Fit given house models to surface heights once more");
  command->add_option("dsm", options->dsm, "Surface heights: GeoTIFF, COG, ASC, VRT, ...")
      ->type_name("DSM")
      ->required();
  command->add_option("--dtm", options->dtm, "Terrain heights, on any grid of the same CRS")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--init", options->init,
                   "Models to start from: .jsonl or .json as gable writes them; extrusions pass "
                   "through")
      ->type_name("MODELS")
      ->required();
  command
      ->add_option("--crs", options->crs,
                   "Reference system of rasters that carry none, in projected metres: EPSG:27700")
      ->type_name("CRS");
  add_spread_option(command, &options->spread);
  add_output_options(command, &options->output);
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
