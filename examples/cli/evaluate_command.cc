#include "examples/cli/evaluate_command.h"

#include <gable/engine/error.h>
#include <gable/engine/evaluate/evaluation.h>
#include <gable/engine/evaluate/evaluation_report.h>
#include <gable/engine/evaluate/triangles.h>
#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/building_plan.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/grammar/polygon_cells.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

#include "examples/cli/model_input.h"

namespace gable {
namespace {

struct EvaluateOptions {
  CommonOptions common;
  std::string models, dsm, dtm, truth, footprints;
  bool per_building = false;
};

/// The world rectangle around everything that is measured.
struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;

  void add(const PlanPolygon& polygon, const Eigen::Vector2d& origin = Eigen::Vector2d::Zero()) {
    for (const Eigen::Vector2d& p : polygon.outer) {
      low = low.cwiseMin(origin + p);
      high = high.cwiseMax(origin + p);
    }
  }

  void add(const std::vector<Building>& buildings) {
    for (const Building& building : buildings) {
      for (const PlanPolygon& polygon : plan_of(building)) {
        add(polygon, origin_of(building).head<2>());
      }
    }
  }
};

/// The cells of the surface around the buildings, so that only those are read.
HeightRaster read_window(const RasterFile& dsm, const Extent& extent, const std::string& models) {
  const Grid& grid = dsm.grid();
  const Eigen::Vector2d first = grid.cell_of({extent.low.x(), extent.high.y()});
  const Eigen::Vector2d last = grid.cell_of({extent.high.x(), extent.low.y()});
  const auto cut = [](double cell, int cells) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells)));
  };
  const int row0 = cut(std::floor(first.x()), grid.rows);
  const int col0 = cut(std::floor(first.y()), grid.cols);
  const int row1 = cut(std::ceil(last.x()) + 1.0, grid.rows);
  const int col1 = cut(std::ceil(last.y()) + 1.0, grid.cols);
  if (row0 >= row1 || col0 >= col1) {
    throw Error(ExitCode::kBadInput, models + ": no building lies on " + dsm.path() +
                                         "; give the height image they were made from");
  }
  return dsm.read(row0, col0, row1 - row0, col1 - col0);
}

int triangles_of(const Building& building) {
  int triangles = 0;
  for (const PartModel& part : build_model(building).parts) {
    triangles += count_triangles(finest_solid(part));
  }
  return triangles;
}

void run(const EvaluateOptions& options, const CommandContext& context) {
  const RasterFile dsm_file(options.dsm);
  const RasterFile dtm_file(options.dtm);
  require_matching(dsm_file, dtm_file);
  const std::vector<Building> buildings = read_models(options.models, dsm_file);
  std::vector<Building> truth;
  Extent extent;
  extent.add(buildings);
  if (!options.truth.empty()) {
    truth = read_models(options.truth, dsm_file);
    extent.add(truth);
  }
  FootprintFile footprints;
  if (!options.footprints.empty()) {
    footprints = read_footprints(options.footprints, dsm_file.crs(), dsm_file.grid());
    for (const Footprint& footprint : footprints.footprints) extent.add(footprint.polygon);
  }
  const HeightRaster dsm = read_window(dsm_file, extent, options.models);
  const HeightRaster dtm = dtm_file.read_onto(dsm.grid);
  EvaluationInput input;
  input.buildings = &buildings;
  input.dsm = &dsm;
  input.dtm = &dtm;
  if (!options.truth.empty()) input.truth = &truth;
  Raster<unsigned char> outlined(dsm.grid, 0);
  for (const Footprint& footprint : footprints.footprints) {
    for_cells_in_polygon(footprint.polygon, Eigen::Vector2d::Zero(), dsm.grid,
                         [&](int row, int col) { outlined.at(row, col) = 1; });
  }
  if (!options.footprints.empty()) input.footprints = &outlined;
  for (const Building& building : buildings) {
    if (context.stop.stop_requested()) throw Error(ExitCode::kInterrupted, "interrupted");
    input.triangles.push_back(triangles_of(building));
  }
  std::cout << evaluation_report(evaluate(input), options.per_building);
}

}  // namespace

void add_evaluate_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<EvaluateOptions>();
  CLI::App* command =
      app->add_subcommand("evaluate", "Measure models against heights, and against a truth");
  command->add_option("models", options->models, "Models: .jsonl or .json as gable writes them")
      ->type_name("MODELS")
      ->required();
  command->add_option("--dsm", options->dsm, "Surface heights")->type_name("FILE")->required();
  command->add_option("--dtm", options->dtm, "Terrain heights")->type_name("FILE")->required();
  command->add_option("--truth", options->truth, "The true models")->type_name("FILE");
  command
      ->add_option("--footprints", options->footprints,
                   "Known outlines: the error over their cells as well, misses counted")
      ->type_name("FILE");
  command->add_flag("--per-building", options->per_building, "A line for every building as well");
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
