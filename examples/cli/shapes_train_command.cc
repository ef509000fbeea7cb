#include "examples/cli/shapes_train_command.h"

#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/shapes/scale_labels_file.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/io/staged_folder.h>
#include <gable/engine/scales/train_scales.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "examples/cli/scan_input.h"
#include "examples/cli/scan_trajectories.h"
#include "examples/cli/training_text.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

struct TrainOptions {
  CommonOptions common;
  ReadScanOptions reading;
  std::vector<std::string> scans;
  std::string labels, folder, name;
  ScaleTrainingOptions training;
};

std::string model_name(const TrainOptions& options) {
  std::string name = options.name;
  if (name.empty()) {
    const fs::path folder = fs::absolute(options.folder).lexically_normal();
    name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  }
  const bool plain = !name.empty() && name.size() <= 100 && name.front() != '.' &&
                     std::none_of(name.begin(), name.end(),
                                  [](unsigned char c) { return c < 32 || c == 127 || c == '/'; });
  if (!plain) {
    throw Error(ExitCode::kUsage, "--name " + name +
                                      ": give 1 to 100 bytes without '/' and control characters, "
                                      "not starting with '.'");
  }
  return name;
}

/// The scans that the labels know, and what they know; others are skipped with a line.
std::vector<std::pair<std::string, ScaleLabels>> labelled_scans(const TrainOptions& options,
                                                                const ScaleLabelsFile& labels) {
  std::map<std::string, ScaleLabels> known;
  for (const ScanScaleLabels& scan : labels.scans) known[scan.file] = scan.labels;
  std::vector<std::pair<std::string, ScaleLabels>> found;
  for (const std::string& file : scan_files(options.scans)) {
    const auto entry = known.find(name_in_labels(file, options.labels));
    if (entry != known.end()) {
      found.emplace_back(file, entry->second);
    } else if (!options.common.quiet) {
      std::cerr << file << ": left out, " << options.labels << " does not name it" << std::endl;
    }
  }
  if (found.empty()) {
    throw Error(ExitCode::kBadInput, options.labels +
                                         ": names none of the scans; annotate them "
                                         "with gable shapes annotate");
  }
  return found;
}

void run(const TrainOptions& options, const CommandContext& context) {
  const std::string name = model_name(options);
  const ScaleLabelsFile labels = read_scale_labels(options.labels);
  const auto scans = labelled_scans(options, labels);
  StagedFolder outputs(options.folder);

  std::vector<std::string> files;
  for (const auto& [file, known] : scans) files.push_back(file);
  std::vector<std::vector<ScaleFeatures>> features(scans.size());
  for_trajectories(files, options.reading, options.common, context,
                   [&](size_t i, const ScanTrajectory& trajectory) {
                     const ScaleLabels& known = scans[i].second;
                     const int n = trajectory.collapsed.trajectory.num_configurations();
                     if (n != known.num_configurations) {
                       throw Error(ExitCode::kBadInput,
                                   files[i] + ": has " + std::to_string(n) + " configurations, " +
                                       options.labels + " was made from " +
                                       std::to_string(known.num_configurations) +
                                       "; annotate the scan again with gable shapes annotate");
                     }
                     features[i] = trajectory.collapsed.trajectory.features;
                   });
  std::vector<std::vector<ScaleFeatures>> used;
  std::vector<ScaleLabels> known;
  for (size_t i = 0; i < scans.size(); ++i) {
    if (features[i].empty()) continue;  // without shapes
    used.push_back(std::move(features[i]));
    known.push_back(scans[i].second);
  }
  if (used.empty()) {
    throw Error(ExitCode::kBadInput, options.labels + ": none of its scans has planar shapes");
  }
  const ScaleTraining training = train_scales(name, used, known, options.training);
  write_scale_model(training.model, outputs.path(name + ".scales"));
  write_file_atomically(outputs.path(name + ".md"), model_card(training, options.training));
  if (context.stop.stop_requested()) {
    throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  }
  outputs.commit();
  std::cout << training_text(training);
}

}  // namespace

void add_shapes_train_command(CLI::App* shapes, const CommandContext& context) {
  auto options = std::make_shared<TrainOptions>();
  CLI::App* command = shapes->add_subcommand(
      "train", "Train a model of structural scales on scans whose scales are marked");
  command->add_option("scans", options->scans, "Scans, or folders of scans")
      ->type_name("SCANS")
      ->required();
  command->add_option("--labels", options->labels, "Where scales begin, from gable shapes annotate")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for the model, NAME.scales, and what it was trained on, NAME.md")
      ->type_name("DIR")
      ->required();
  command->add_option("--name", options->name, "Name of the model; without it that of the folder")
      ->type_name("NAME");
  command
      ->add_option("--seed", options->training.seed,
                   "Of the trees, and of which scans train and which test")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--training-share", options->training.training_share,
                   "Share of the scans that train; the others test")
      ->type_name("SHARE")
      ->check(CLI::Range(1e-9, 1.0))
      ->capture_default_str();
  command
      ->add_option("--crs", options->reading.raster_crs,
                   "Reference system of height rasters that carry none: EPSG:27700")
      ->type_name("CRS");
  add_common_options(command, &options->common);
  command->callback([options, context] {
    options->training.forest.seed = options->training.seed;
    run(*options, context);
  });
}

}  // namespace gable
