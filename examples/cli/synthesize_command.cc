#include "examples/cli/synthesize_command.h"

#include <gable/engine/dataset/write_dataset.h>
#include <gable/engine/error.h>
#include <gable/engine/evaluate/evaluation.h>
#include <gable/engine/io/crs.h>
#include <gable/engine/io/footprint_writer.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/model_writer.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gable/grammar/synthesis/survey/mean_cells.h>
#include <gable/grammar/synthesis/village.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include "examples/cli/new_folder.h"
#include "examples/cli/progress.h"

namespace gable {
namespace {

/// The British National Grid: the houses are English.
constexpr const char* kCrs = "EPSG:27700";

constexpr int kMostHouses = 100000;  // of a village

struct SynthesizeOptions {
  CommonOptions common;
  VillageOptions village;
  std::string folder;
  bool dataset = false;
  std::string cells;  ///< of a village: "samples", "means", "resampled"
};

/// Cells that are means are made of so many samples along their side.
constexpr int kSamples = 4;

constexpr double kLeastGsd = 0.1;  // of a village's samples, metres

/// The village, its rasters as the cells are asked for.
Village surveyed_village(const SynthesizeOptions& options) {
  if (options.cells == "samples") return synthesize_village(options.village);
  VillageOptions fine = options.village;
  fine.gsd /= kSamples;
  if (fine.gsd < kLeastGsd) {
    throw Error(ExitCode::kUsage, "--cells " + options.cells +
                                      ": such cells are at least 0.4 m wide; give a larger --gsd");
  }
  Village village = synthesize_village(fine);
  village.dsm = mean_cells(village.dsm, kSamples,
                           options.cells == "means" ? CellMeans::kOver : CellMeans::kResampled);
  village.dtm = mean_cells(village.dtm, kSamples, CellMeans::kOver);
  return village;
}

std::string house_id(size_t number) {
  char id[32];
  std::snprintf(id, sizeof(id), "house_%04zu", number + 1);
  return id;
}

/// The truth as buildings; their quality is the fit of the truth itself to the noisy heights.
std::vector<Building> truth_buildings(const Village& village) {
  std::vector<Building> buildings;
  for (size_t i = 0; i < village.houses.size(); ++i) {
    Building building;
    building.id = house_id(i);
    building.house = village.houses[i];
    building.base = village.base[i];
    buildings.push_back(building);
  }
  const Evaluation evaluation = evaluate({&buildings, &village.dsm, &village.dtm, nullptr, {}});
  for (size_t i = 0; i < buildings.size(); ++i) {
    const HeightError& error = evaluation.buildings[i].over_model;
    buildings[i].quality = {error.mad(), error.rmse(), -1.0};
  }
  return buildings;
}

void write_truth(const std::string& path, const Village& village, const Crs& crs,
                 const SynthesizeOptions& options, const CommandContext& context) {
  const std::vector<Building> buildings = truth_buildings(village);
  ModelWriterOptions writer_options;
  writer_options.crs = crs;
  writer_options.anchor = village.houses.front().origin;
  const auto writer = open_model_writer(path, writer_options);
  Progress progress("houses", buildings.size(), progress_style(options.common.quiet), std::cerr);
  for (const Building& building : buildings) {
    if (context.stop.stop_requested()) throw Error(ExitCode::kInterrupted, "interrupted");
    writer->append(building, build_model(building));
    progress.advance();
  }
  writer->close();
}

void make_dataset(const SynthesizeOptions& options, const CommandContext& context) {
  DatasetOptions dataset;
  dataset.count = options.village.count;
  dataset.seed = options.village.seed;
  const size_t count = static_cast<size_t>(dataset.count);
  size_t done = 0;
  {
    Progress progress("crops", count, progress_style(options.common.quiet), std::cerr);
    const auto advance = [&](size_t crops) { progress.set_done(done += crops); };
    if (!write_dataset(options.folder, dataset, options.common.num_threads(), context.stop,
                       advance)) {
      throw Error(ExitCode::kInterrupted, "interrupted");
    }
  }
  if (!options.common.quiet) std::cout << options.folder << ": " << count << " crops\n";
}

void run(const SynthesizeOptions& options, const CommandContext& context) {
  make_folder(options.folder);
  if (options.dataset) {
    make_dataset(options, context);
    return;
  }
  if (options.village.count > kMostHouses) {
    throw Error(ExitCode::kUsage, "--count: a village has at most " + std::to_string(kMostHouses) +
                                      " houses; more are made with --dataset");
  }
  const std::filesystem::path folder(options.folder);
  const Village village = surveyed_village(options);
  const Crs crs = crs_from_text(kCrs);
  std::vector<Footprint> footprints;
  for (size_t i = 0; i < village.footprints.size(); ++i) {
    footprints.push_back({house_id(i), village.footprints[i]});
  }
  write_truth((folder / "truth.city.jsonl").string(), village, crs, options, context);
  write_raster((folder / "dsm.tif").string(), village.dsm, crs);
  write_raster((folder / "dtm.tif").string(), village.dtm, crs);
  write_footprints((folder / "footprints.gpkg").string(), footprints, crs);
  if (!options.common.quiet) {
    const Grid& grid = village.dsm.grid;
    std::cout << options.folder << ": " << village.houses.size() << " houses, " << grid.cols
              << " x " << grid.rows << " cells of " << grid.gsd << " m\n";
  }
}

}  // namespace

void add_synthesize_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<SynthesizeOptions>();
  CLI::App* command = app->add_subcommand(
      "synthesize",
      "Make a village of random houses as a LiDAR survey would see it, or a training set");
  command->add_option("--count", options->village.count, "Houses, or crops")
      ->type_name("N")
      ->check(CLI::Range(1, 100000000))
      ->capture_default_str();
  command->add_option("--seed", options->village.seed, "The same seed gives the same files")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--gsd", options->village.gsd, "Cell size of a village, metres")
      ->type_name("METRES")
      ->check(CLI::Range(kLeastGsd, 2.0))
      ->capture_default_str();
  command
      ->add_option(
          "--cells", options->cells,
          "What a village's cells hold: samples, one return each; means, over the cell; "
          "resampled, the same smeared over one more cell, as rasters are that were brought "
          "to another grid")
      ->check(CLI::IsMember({"samples", "means", "resampled"}))
      ->default_val("samples");
  command->add_flag("--dataset", options->dataset,
                    "Crops of single houses with the detectors' targets instead of a village");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for dsm.tif, dtm.tif, footprints.gpkg and truth.city.jsonl; with "
                   "--dataset for NPY shards and dataset.json")
      ->type_name("DIR")
      ->required();
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
