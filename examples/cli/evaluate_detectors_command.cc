#include "examples/cli/evaluate_detectors_command.h"

#include <gable/engine/dataset/annotated_images.h>
#include <gable/engine/dataset/synthetic_samples.h>
#include <gable/engine/error.h>
#include <gable/engine/evaluate/detectors/detector_scores.h>
#include <gable/engine/io/answers/annotations_file.h>
#include <gable/engine/io/model_folder.h>
#include <gable/engine/parallel_ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "examples/cli/progress.h"
#include "examples/cli/tile_files.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

// Buildings that share less with their annotation are not the ones that were annotated.
constexpr double kLeastIou = 0.4;

struct EvaluateDetectorsOptions {
  CommonOptions common;
  std::vector<std::string> models;
  int synthetic = 2000;
  DatasetOptions dataset;
  double gsd = 0.0;  ///< of the synthetic crops, metres; 0: mixed
  std::vector<std::string> real;
  std::string data;
  std::string confidence = "medium";
};

/// Annotated buildings with their heights.
struct RealHouses {
  std::vector<AnnotatedHouse> houses;
  std::vector<HeightImage> images;
  size_t not_found = 0;
};

std::string in_data(const EvaluateDetectorsOptions& options, const std::string& file) {
  if (file.empty() || fs::path(file).is_absolute()) return file;
  std::string data = options.data;
  if (data.empty() && std::getenv("GABLE_DATA") != nullptr) data = std::getenv("GABLE_DATA");
  return (fs::path(data.empty() ? "." : data) / file).string();
}

void read_real(const std::string& path, const EvaluateDetectorsOptions& options,
               const CommandContext& context, RealHouses* real) {
  const AnnotatedTile tile = read_annotations(path);
  const Confidence least = *confidence_from_name(options.confidence);
  std::vector<AnnotatedHouse> houses;
  for (const AnnotatedHouse& house : tile.houses) {
    if (house.confidence >= least) houses.push_back(house);
  }
  const std::string dsm = in_data(options, tile.source.tile);
  if (std::error_code none; !fs::exists(dsm, none)) {
    throw Error(ExitCode::kNoInput, dsm + ": does not exist, and " + path +
                                        " was annotated in it; say with --data where it lies");
  }
  TileFileOptions tile_files;
  tile_files.dsm = dsm;
  tile_files.dtm = in_data(options, tile.source.dtm);
  tile_files.footprints = in_data(options, tile.source.footprints);
  tile_files.crs = tile.source.crs;
  const TileFiles files(tile_files, [](const std::string&) {});
  TileOptions tile_options;
  tile_options.threads = options.common.num_threads();
  std::vector<AnnotatedImage> images =
      annotated_images(files.input(), tile_options, houses, kLeastIou, context.stop);
  real->not_found += houses.size() - images.size();
  for (AnnotatedImage& image : images) {
    real->houses.push_back(houses[image.house]);
    real->images.push_back(std::move(image.image));
  }
}

/// Scores of `count` buildings whose truth is `truth(i, nets)`: parts of fixed size, each with its
/// own networks, so that the sums do not depend on the number of threads.
template <typename Truth>
DetectorScores scores_of(size_t count, const std::string& models,
                         const EvaluateDetectorsOptions& options, const CommandContext& context,
                         const Truth& truth) {
  constexpr size_t kPart = 64;
  std::vector<DetectorScores> parts((count + kPart - 1) / kPart);
  Progress progress("crops", count, progress_style(options.common.quiet), std::cerr);
  for_ranges(
      count, options.common.num_threads(),
      [&](size_t begin, size_t end) {
        DetectorNets nets(models);
        for (size_t i = begin; i < end && !context.stop.stop_requested(); ++i) {
          add_score(truth(i, &nets), &nets, &parts[begin / kPart]);
          progress.advance();
        }
      },
      kPart);
  if (context.stop.stop_requested()) throw Error(ExitCode::kInterrupted, "interrupted");
  DetectorScores sum;
  for (const DetectorScores& part : parts) sum += part;
  return sum;
}

void run(const EvaluateDetectorsOptions& options, const CommandContext& context) {
  std::vector<std::string> models = options.models;
  if (models.empty()) models.push_back(find_detector_models());
  for (const std::string& folder : models) DetectorNets tried(folder);
  RealHouses real;
  for (const std::string& path : options.real) read_real(path, options, context, &real);

  std::vector<std::pair<std::string, DetectorScores>> scores;
  for (const std::string& folder : models) {
    const std::string suffix = models.size() > 1 ? " " + fs::path(folder).filename().string() : "";
    if (options.synthetic > 0) {
      scores.emplace_back("synthetic" + suffix,
                          scores_of(static_cast<size_t>(options.synthetic), folder, options,
                                    context, [&](size_t i, DetectorNets*) {
                                      return truth_of(synthetic_sample(i, options.dataset));
                                    }));
    }
    if (!real.houses.empty()) {
      scores.emplace_back("real" + suffix,
                          scores_of(real.houses.size(), folder, options, context,
                                    [&](size_t i, DetectorNets* nets) {
                                      const HeightImage& image = real.images[i];
                                      const double azimuth =
                                          nets->azimuth(make_house_crop(image, 0.0)).angle();
                                      return truth_of(real.houses[i], image, azimuth);
                                    }));
    }
  }
  std::vector<ScoreColumn> columns;
  for (const auto& [title, score] : scores) columns.push_back({title, &score});
  std::cout << score_table(columns);
  if (real.not_found > 0) {
    std::cout << "\n" << real.not_found << " annotated buildings were not found in the heights\n";
  }
}

}  // namespace

void add_evaluate_detectors_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<EvaluateDetectorsOptions>();
  options->dataset.seed = 1000003;
  CLI::App* command = app->add_subcommand(
      "evaluate-detectors", "Score the learned detectors on synthetic and on annotated crops");
  command
      ->add_option("--models", options->models,
                   "Folders with house.onnx, roof.onnx and azimuth.onnx, each scored; without it "
                   "the detectors that reconstruction uses")
      ->type_name("DIR");
  command
      ->add_option("--synthetic", options->synthetic,
                   "Synthetic crops, foundations I, II, III, L, U and C in turn; 0: none")
      ->type_name("N")
      ->check(CLI::Range(0, 10000000))
      ->capture_default_str();
  command
      ->add_option("--seed", options->dataset.seed,
                   "Of the synthetic crops; give one that was not trained on")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--gsd", options->gsd, "Cell size of the synthetic crops, metres; else mixed")
      ->type_name("METRES")
      ->check(CLI::Range(0.1, 2.0));
  command->add_option("--real", options->real, "Annotated buildings, see gable annotate")
      ->type_name("FILE");
  command
      ->add_option("--data", options->data,
                   "Folder that the tiles of --real lie in; without it $GABLE_DATA")
      ->type_name("DIR");
  command
      ->add_option("--least-confidence", options->confidence,
                   "Annotations less sure than this are left out")
      ->check(CLI::IsMember({"low", "medium", "high"}))
      ->capture_default_str();
  add_common_options(command, &options->common);
  command->callback([options, context] {
    if (options->gsd > 0.0) {
      options->dataset.scene.least_gsd = options->dataset.scene.most_gsd = options->gsd;
    }
    run(*options, context);
  });
}

}  // namespace gable
