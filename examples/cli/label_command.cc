#include "examples/cli/label_command.h"

#include <gable/engine/dataset/annotated_images.h>
#include <gable/engine/dataset/dataset_folder.h>
#include <gable/engine/dataset/real_sample.h>
#include <gable/engine/error.h>
#include <gable/engine/io/answers/annotations_file.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "examples/cli/detector_options.h"
#include "examples/cli/extent_option.h"
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
  ExtentOption extent;
  RealSampleOptions sample;
  std::string annotations;
};

// Buildings that share less with an annotation are not the annotated ones.
constexpr double kLeastIou = 0.4;

/// How many labels agree with annotations.
struct Agreement {
  size_t right = 0, all = 0;
};

void compare(const TrainingSample& sample, const HeightImage& image,
             const std::vector<AnnotatedHouse>& houses, Agreement* agreement) {
  double best = kLeastIou;
  const AnnotatedHouse* same = nullptr;
  for (const AnnotatedHouse& house : houses) {
    if (house.confidence == Confidence::kLow) continue;
    if ((house.center - image.origin.head<2>()).norm() > image.gsd * image.rows) continue;
    const double iou = annotation_iou(image, house);
    if (iou < best) continue;
    best = iou;
    same = &house;
  }
  if (same == nullptr) return;
  ++agreement->all;
  agreement->right += same->foundation == sample.foundation;
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
  std::vector<AnnotatedHouse> annotated;
  if (!options.annotations.empty()) annotated = read_annotations(options.annotations).houses;
  Agreement agreement;
  TileCallbacks callbacks;
  callbacks.begin_window = [&](int, int, size_t num_buildings) {
    progress.reset();
    progress = std::make_unique<Progress>("buildings", num_buildings,
                                          progress_style(options.common.quiet), std::cerr);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    progress->advance();
    if (!options.extent.holds(made.image.origin.head<2>())) return;
    ++verdicts[static_cast<size_t>(judge(made, options.sample))];
    auto sample = real_sample(made, options.sample);
    if (!sample) return;
    compare(*sample, made.image, annotated, &agreement);
    samples.push_back(std::move(*sample));
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
  if (!options.annotations.empty()) {
    std::cout << options.annotations << ": " << agreement.right << " of " << agreement.all
              << " labels have the annotated foundation type\n";
  }
}

}  // namespace

void add_label_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<LabelOptions>();
  CLI::App* command = app->add_subcommand(
      "label", "Write crops of the houses that reconstruction is sure of, as a training set");
  add_tile_file_options(command, &options->tile);
  add_detector_options(command, &options->detectors);
  add_extent_option(command, &options->extent);
  command
      ->add_option("--annotations", options->annotations,
                   "Say how many labels agree with these annotations (see gable annotate)")
      ->type_name("FILE");
  command
      ->add_option("--least-probability", options->sample.least_probability,
                   "How probable the detectors must find the type")
      ->type_name("P")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
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
