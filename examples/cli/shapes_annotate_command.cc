#include "examples/cli/shapes_annotate_command.h"

#include <gable/engine/drawing/report_file.h>
#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/shapes/scale_labels_file.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/io/staged_folder.h>
#include <gable/engine/scales/report/contact_sheet.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "examples/cli/scale_proposals.h"
#include "examples/cli/scan_input.h"
#include "examples/cli/scan_trajectories.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr char kUsualModel[] = "buildings";
constexpr int kUsualScales = 3;

struct AnnotateOptions {
  CommonOptions common;
  ReadScanOptions reading;
  std::vector<std::string> scans;
  std::string labels, sheets, model;
  int num_scales = 0;
};

/// The model asked for, or else the usual one where it is installed.
std::optional<ScaleModel> proposing_model(const std::string& name) {
  if (!name.empty()) return read_scale_model(find_scale_model(name));
  const std::vector<std::string> names = scale_model_names();
  if (std::find(names.begin(), names.end(), kUsualModel) == names.end()) return std::nullopt;
  return read_scale_model(find_scale_model(kUsualModel));
}

int number_of_scales(const AnnotateOptions& options, const ScaleLabelsFile& before,
                     const std::vector<std::string>& files, const ScaleModel* model) {
  if (before.num_scales > 0) {
    if (options.num_scales > 0 && options.num_scales != before.num_scales) {
      throw Error(ExitCode::kUsage, options.labels + ": has " + std::to_string(before.num_scales) +
                                        " scales, not " + std::to_string(options.num_scales) +
                                        "; give another file");
    }
    return before.num_scales;
  }
  if (options.num_scales > 0) return options.num_scales;
  const size_t known = known_planes(read_scan(files.front(), options.reading)).size();
  if (known > 0) return static_cast<int>(known);
  return model != nullptr ? model->num_scales() : kUsualScales;
}

/// A name for a scan's sheet that tells scans in different folders apart.
std::string sheet_name(const std::string& name_of_scan) {
  std::string name;
  for (const fs::path& part : fs::path(name_of_scan)) {
    if (part == ".." || part == "." || part == "/") continue;
    name += (name.empty() ? "" : "-") + part.string();
  }
  return name + ".png";
}

/// What a person has marked stays, as long as the trajectory is the same.
void keep_marks(const ScaleLabelsFile& before, ScanScaleLabels* scan) {
  for (const ScanScaleLabels& old : before.scans) {
    if (old.file == scan->file &&
        old.labels.num_configurations == scan->labels.num_configurations) {
      *scan = old;
    }
  }
}

ScaleLabelsFile merged(ScaleLabelsFile before, const std::vector<ScanScaleLabels>& scans) {
  for (const ScanScaleLabels& scan : scans) {
    if (scan.file.empty()) continue;  // left out
    const auto same = std::find_if(before.scans.begin(), before.scans.end(),
                                   [&](const ScanScaleLabels& s) { return s.file == scan.file; });
    if (same != before.scans.end()) {
      *same = scan;
    } else {
      before.scans.push_back(scan);
    }
  }
  return before;
}

void run(const AnnotateOptions& options, const CommandContext& context) {
  const std::vector<std::string> files = scan_files(options.scans);
  const std::optional<ScaleModel> model = proposing_model(options.model);
  std::error_code none;
  ScaleLabelsFile before;
  if (fs::exists(options.labels, none)) before = read_scale_labels(options.labels);
  before.num_scales = number_of_scales(options, before, files, model ? &*model : nullptr);
  if (!options.model.empty() && model->num_scales() != before.num_scales) {
    throw Error(ExitCode::kUsage, "--model " + options.model + ": has " +
                                      std::to_string(model->num_scales()) + " scales, not " +
                                      std::to_string(before.num_scales));
  }
  const std::string sheets = options.sheets.empty()
                                 ? fs::path(options.labels).replace_extension().string()
                                 : options.sheets;
  if (fs::path(sheets).lexically_normal() == fs::path(options.labels).lexically_normal()) {
    throw Error(ExitCode::kUsage, "-o " + options.labels + ": end the name with .json");
  }

  AtomicFile{options.labels};  // whether it can be written, before any work is done
  StagedFolder staged(sheets);
  std::vector<ScanScaleLabels> scans(files.size());
  for_trajectories(
      files, options.reading, options.common, context,
      [&](size_t i, const ScanTrajectory& trajectory) {
        const ScaleProposal proposal = propose_scales(trajectory.scan, trajectory.collapsed,
                                                      before.num_scales, model ? &*model : nullptr);
        ScanScaleLabels& scan = scans[i];
        scan = {name_in_labels(trajectory.path, options.labels), proposal.labels, proposal.known};
        keep_marks(before, &scan);
        const cv::Mat sheet = draw_contact_sheet(trajectory.scan, trajectory.collapsed.first_shapes,
                                                 trajectory.collapsed.trajectory, scan.labels,
                                                 fs::path(trajectory.path).filename().string());
        write_file_atomically(staged.path(sheet_name(scan.file)), png_bytes(sheet));
      });
  write_scale_labels(options.labels, merged(before, scans));
  staged.commit();
  if (!options.common.quiet) {
    const auto made = std::count_if(scans.begin(), scans.end(),
                                    [](const ScanScaleLabels& s) { return !s.file.empty(); });
    std::cout << options.labels << ": " << made << " scans, sheets in " << sheets
              << "; correct \"first\" where a scale begins elsewhere\n";
  }
}

}  // namespace

void add_shapes_annotate_command(CLI::App* shapes, const CommandContext& context) {
  auto options = std::make_shared<AnnotateOptions>();
  CLI::App* command = shapes->add_subcommand(
      "annotate", "Draw contact sheets of trajectories, and propose where scales begin");
  command->add_option("scans", options->scans, "Scans, or folders of scans")
      ->type_name("SCANS")
      ->required();
  command
      ->add_option("-o,--output", options->labels,
                   "Labels (JSON), to be corrected by hand; what is already marked in it stays")
      ->type_name("FILE")
      ->required();
  command
      ->add_option("--sheets", options->sheets,
                   "Folder for the contact sheets; without it named after the labels")
      ->type_name("DIR");
  command
      ->add_option("--model", options->model,
                   "Model that proposes; without it buildings where that is installed. Scans with "
                   "labels scale_1, scale_2, ... need none")
      ->type_name("NAME");
  command
      ->add_option("--scales", options->num_scales,
                   "Scales to mark; without it those that the first scan knows, or the model's")
      ->type_name("K")
      ->check(CLI::Range(1, 62));
  command
      ->add_option("--crs", options->reading.raster_crs,
                   "Reference system of height rasters that carry none: EPSG:27700")
      ->type_name("CRS");
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
