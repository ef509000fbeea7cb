#include "examples/cli/shapes_evaluate_command.h"

#include <gable/engine/error.h>
#include <gable/engine/evaluate/shape_evaluation.h>
#include <gable/engine/io/scans/scan_file.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "examples/cli/scale_proposals.h"
#include "examples/cli/shapes_outputs.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

struct EvaluateShapesOptions {
  CommonOptions common;
  std::string folder, input, truth, crs;
};

std::map<int, std::string> scale_files(const std::string& folder) {
  std::error_code error;
  std::map<int, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const int number = scale_number(entry.path().filename().string(), ".ply");
    if (number > 0) files[number] = entry.path().string();
  }
  if (error) throw Error(ExitCode::kNoInput, folder + ": " + error.message());
  if (files.empty()) {
    throw Error(ExitCode::kNoInput,
                folder + ": has no scale-1.ply; give a folder that gable shapes wrote");
  }
  return files;
}

/// The shapes in a file that was made from a scan.
std::vector<int> shapes_in(const std::string& path, const Scan& scan, const std::string& input) {
  Scan shapes = read_scan(path);
  const auto found = shapes.labels.find("shape");
  if (found == shapes.labels.end()) {
    throw Error(ExitCode::kBadInput, path +
                                         ": has no property shape; give a folder that gable "
                                         "shapes wrote");
  }
  bool same = shapes.is_mesh() == scan.is_mesh() && shapes.points.size() == scan.points.size() &&
              shapes.num_elements() == scan.num_elements();
  // Other programs may have rounded coordinates to float.
  constexpr double kRounding = 1e-6;
  for (size_t i = 0; same && i < scan.points.size(); ++i) {
    const double size = std::max(1.0, scan.points[i].norm());
    same = (shapes.points[i] - scan.points[i]).norm() <= kRounding * size;
  }
  if (!same) {
    throw Error(ExitCode::kBadInput,
                path + ": was made from another scan than " + input + "; give that one");
  }
  return std::move(found->second);
}

void run(const EvaluateShapesOptions& options, const CommandContext& context) {
  const std::map<int, std::string> files = scale_files(options.folder);
  const Scan scan = read_scan(options.input, {options.crs});
  const std::vector<std::vector<int>> known = known_planes(scan);
  const std::vector<int>* truth = nullptr;
  if (!options.truth.empty()) {
    const auto found = scan.labels.find(options.truth);
    if (found == scan.labels.end()) {
      std::string names;
      for (const auto& [name, values] : scan.labels) names += " " + name;
      throw Error(ExitCode::kBadInput, options.input + ": has no property " + options.truth +
                                           (names.empty() ? "; it has none" : "; it has" + names));
    }
    truth = &found->second;
  }
  const bool with_index = truth != nullptr || !known.empty();
  std::string table = "scale  planes  coverage %    RMS %  worst RMS %";
  table += with_index ? "  Rand index\n" : "\n";
  for (const auto& [number, path] : files) {
    if (context.stop.stop_requested()) throw Error(ExitCode::kInterrupted, "interrupted");
    const std::vector<int> shape_of = shapes_in(path, scan, options.input);
    const ShapeEvaluation fit = evaluate_shapes(scan, shape_of);
    const double percent = fit.diagonal > 0.0 ? 100.0 / fit.diagonal : 0.0;
    char line[160];
    std::snprintf(line, sizeof(line), "%5d  %6d  %10.2f  %7.5f  %11.5f", number, fit.planes,
                  100.0 * fit.coverage, percent * fit.rms, percent * fit.worst_rms);
    table += line;
    const std::vector<int>* planes = truth;
    if (planes == nullptr && number <= static_cast<int>(known.size())) planes = &known[number - 1];
    if (planes != nullptr) {
      std::snprintf(line, sizeof(line), "  %10.4f", agreement_index(shape_of, *planes));
      table += line;
    }
    table += "\n";
  }
  std::cout << table;
}

}  // namespace

void add_shapes_evaluate_command(CLI::App* shapes, const CommandContext& context) {
  auto options = std::make_shared<EvaluateShapesOptions>();
  CLI::App* command = shapes->add_subcommand(
      "evaluate", "Measure planar shapes against their scan, and against known planes");
  command->add_option("shapes", options->folder, "Folder that gable shapes wrote")
      ->type_name("DIR")
      ->required();
  command->add_option("--input", options->input, "The scan that they were found in")
      ->type_name("SCAN")
      ->required();
  command
      ->add_option("--truth", options->truth,
                   "Integer property of the scan with the known plane of every point or facet; "
                   "without it scale_1, scale_2, ..., each for its own scale, where there are any")
      ->type_name("PROPERTY");
  command
      ->add_option("--crs", options->crs,
                   "Reference system of height rasters that carry none: EPSG:27700")
      ->type_name("CRS");
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
