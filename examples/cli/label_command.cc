#include "examples/cli/label_command.h"

#include <gable/engine/dataset/dataset_folder.h>
#include <gable/engine/dataset/real_sample.h>
#include <gable/engine/error.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "examples/cli/detector_options.h"
#include "examples/cli/new_folder.h"
#include "examples/cli/progress.h"
#include "examples/cli/tile_files.h"

namespace gable {
namespace {

struct LabelOptions {
  CommonOptions common;
  TileFileOptions tile;
  DetectorOptions detectors;
  std::string folder;
  std::vector<double> extent;
  RealSampleOptions sample;
};

bool wanted(const LabelOptions& options, const Eigen::Vector3d& world) {
  const std::vector<double>& e = options.extent;
  return e.empty() ||
         (world.x() >= e[0] && world.y() >= e[1] && world.x() < e[2] && world.y() < e[3]);
}

void run(const LabelOptions& options, const CommandContext& context) {
  const auto say = [&](const std::string& line) {
    if (!options.common.quiet) std::cerr << line << std::endl;
  };
  make_folder(options.folder);
  const TileFiles files(options.tile, say);
  DatasetFolder dataset(options.folder,
                        std::filesystem::path(options.tile.dsm).filename().string());
  TileOptions tile_options;
  tile_options.threads = options.common.num_threads();
  tile_options.detectors = options.detectors.folder();
  std::unique_ptr<Progress> progress;
  std::array<size_t, 4> verdicts{};
  std::vector<TrainingSample> samples;
  TileCallbacks callbacks;
  callbacks.begin_window = [&](int, int, size_t num_buildings) {
    progress.reset();
    progress = std::make_unique<Progress>("buildings", num_buildings,
                                          progress_style(options.common.quiet), std::cerr);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    progress->advance();
    if (!wanted(options, made.image.origin)) return;
    ++verdicts[static_cast<size_t>(judge(made, options.sample))];
    if (auto sample = real_sample(made, options.sample)) samples.push_back(std::move(*sample));
  };
  const TileSummary summary =
      reconstruct_tile(files.input(), tile_options, context.stop, callbacks);
  progress.reset();
  if (summary.stopped) throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  dataset.append(samples);
  dataset.close();
  if (options.common.quiet) return;
  std::cout << options.folder << ": " << samples.size() << " crops: " << verdicts[0] << " houses, "
            << verdicts[1] << " beyond the grammar; left out: " << verdicts[2]
            << " with a poor fit, " << verdicts[3] << " with a close second\n";
}

}  // namespace

void add_label_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<LabelOptions>();
  CLI::App* command = app->add_subcommand(
      "label", "Write crops of the houses that reconstruction is sure of, as a training set");
  add_tile_file_options(command, &options->tile);
  add_detector_options(command, &options->detectors);
  command
      ->add_option("--extent", options->extent,
                   "Only buildings with their centre in west south east north, world metres")
      ->type_name("W S E N")
      ->expected(4);
  command
      ->add_option("--most-mad", options->sample.most_mad,
                   "Largest mean distance from the heights, metres at cells of 0.5 m")
      ->type_name("METRES")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  command
      ->add_option("--least-gap", options->sample.least_gap,
                   "How far ahead of any other foundation type in cost")
      ->type_name("COST")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("-o,--output", options->folder, "Folder for NPY shards and dataset.json")
      ->type_name("DIR")
      ->required();
  add_common_options(command, &options->common);
  command->callback([options, context] {
    if (options->sample.beyond_mad < options->sample.most_mad) {
      options->sample.beyond_mad = options->sample.most_mad;
    }
    run(*options, context);
  });
}

}  // namespace gable
