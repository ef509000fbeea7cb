#include "examples/cli/shapes_command.h"

#include <gable/engine/error.h>
#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/report_folder.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/io/staged_folder.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/lack_of_shapes.h>
#include <gable/engine/scales/report/regularity_angles.h>
#include <gable/engine/scales/report/scales_report.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "examples/cli/scan_input.h"
#include "examples/cli/shapes_annotate_command.h"
#include "examples/cli/shapes_evaluate_command.h"
#include "examples/cli/shapes_outputs.h"
#include "examples/cli/shapes_solids.h"
#include "examples/cli/shapes_train_command.h"

namespace gable {
namespace {

struct ShapesOptions {
  CommonOptions common;
  std::string scan, model = "buildings", folder, report, solids, crs;
  int num_scales = 0;
  double epsilon_percent = FirstShapesOptions{}.epsilon_percent;
  bool no_refit = false;
};

DetectScalesOptions detect_options(const ShapesOptions& options, const ScaleModel& model) {
  DetectScalesOptions detect;
  detect.first_shapes.epsilon_percent = options.epsilon_percent;
  detect.first_shapes.threads = options.common.num_threads();
  detect.refit_planes = !options.no_refit;
  detect.num_scales = options.num_scales;
  if (options.num_scales > model.num_scales()) {
    throw Error(ExitCode::kUsage, "--scales " + std::to_string(options.num_scales) +
                                      " is not in [1, " + std::to_string(model.num_scales()) +
                                      "], the scales of the model " + options.model);
  }
  return detect;
}

ScanFile read_input(const ShapesOptions& options) {
  ScanFile file = read_scan_file(options.scan, {options.crs});
  const std::string skipped = skipped_line(options.scan, file);
  if (!skipped.empty() && !options.common.quiet) std::cerr << skipped << std::endl;
  if (options.epsilon_percent == 0.0 && !file.scan.is_mesh()) {
    throw Error(ExitCode::kUsage, "--epsilon 0 is for meshes, " + options.scan +
                                      " is a cloud of points; give a larger one");
  }
  return file;
}

std::vector<ReportFile> report_of(const Scan& scan, const DetectedScales& detected,
                                  const ShapesOptions& options) {
  std::vector<RegularityAngles> angles;
  for (const PlaneRefit& refit : detected.refits) angles.push_back(regularity_angles(refit));
  return scales_report({.title = std::filesystem::path(options.scan).filename().string(),
                        .scan = scan,
                        .first_shapes = detected.first_shapes,
                        .trajectory = detected.trajectory,
                        .labels = detected.labels,
                        .scales = detected.scales,
                        .angles = angles});
}

void require_going_on(const CommandContext& context) {
  if (context.stop.stop_requested()) {
    throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  }
}

void run(const ShapesOptions& options, const CommandContext& context) {
  const ScaleModel model = read_scale_model(find_scale_model(options.model));
  const DetectScalesOptions detect = detect_options(options, model);
  const Scan scan = read_input(options).scan;
  StagedFolder outputs(options.folder);
  std::optional<StagedFolder> report;
  if (!options.report.empty()) report.emplace(options.report);
  std::optional<StagedFolder> solids;
  if (!options.solids.empty()) solids.emplace(options.solids);

  require_going_on(context);
  const DetectedScales detected = detect_scales(scan, model, detect);
  if (detected.trajectory.num_first == 0) {
    throw Error(ExitCode::kBadInput, options.scan + ": has no planar shapes: " +
                                         lack_of_shapes(scan, detect.first_shapes));
  }
  require_going_on(context);
  write_scales(outputs.staging(), scan, detected);
  if (report) write_report(report->staging(), report_of(scan, detected, options));
  std::string closed_table;
  if (solids) {
    const std::vector<ScanSolid> closed = close_detected_scales(options.scan, scan, detected);
    write_solids(solids->staging(), closed, detected.first_shapes.diagonal);
    closed_table = solids_table(closed, detected.first_shapes.diagonal);
  }
  require_going_on(context);
  if (report) report->commit();
  if (solids) solids->commit();
  outputs.commit();
  remove_further_scales(options.folder, static_cast<int>(detected.scales.size()));
  std::cout << scales_table(detected) << closed_table;
}

}  // namespace

void add_shapes_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<ShapesOptions>();
  CLI::App* command = app->add_subcommand(
      "shapes", "Find the planar shapes of a point cloud or mesh at its structural scales");
  command->footer(
      "A scan that is named like one of the subcommands is given with its folder: ./train");
  command
      ->add_option("scan", options->scan,
                   "Cloud or mesh: PLY, LAS, LAZ, OFF, OBJ, PCD, XYZ, PWN, or a height raster")
      ->type_name("SCAN");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder for scale-K.ply, .json, .obj (1: finest) and trajectory.json")
      ->type_name("DIR");
  command->add_option("--model", options->model, "Name of a trained model, or its file")
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--scales", options->num_scales,
                   "Scales to keep, the most distinct ones; without it all of the model's")
      ->type_name("N")
      ->check(CLI::Range(1, 62));
  command->add_option("--report", options->report, "Folder for a page with a picture per scale")
      ->type_name("DIR");
  command
      ->add_option("--solids", options->solids,
                   "Folder for a closed model per scale, solid-K.obj, and solids.json: the shapes "
                   "that face up over the outline of the scan, walls vertical; a building in "
                   "metres, z up")
      ->type_name("DIR");
  command
      ->add_option("--epsilon", options->epsilon_percent,
                   "Tolerance of the first shapes, % of the bounding box diagonal; more where the "
                   "noise asks for it; 0 (meshes alone): every facet is a shape")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command->add_flag("--no-refit", options->no_refit,
                    "Leave planes as they fit their own points best, without regularities");
  command
      ->add_option("--crs", options->crs,
                   "Reference system of height rasters that carry none: EPSG:27700")
      ->type_name("CRS");
  add_common_options(command, &options->common);
  command->require_subcommand(0, 1);
  add_shapes_annotate_command(command, context);
  add_shapes_train_command(command, context);
  add_shapes_evaluate_command(command, context);
  for (CLI::App* subcommand : command->get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      if (option != command->get_help_ptr()) subcommand->excludes(option);
    }
  }
  command->callback([options, context, command] {
    if (!command->get_subcommands().empty()) return;
    if (options->scan.empty()) throw CLI::RequiredError("SCAN");
    if (options->folder.empty()) throw CLI::RequiredError("--output");
    run(*options, context);
  });
}

}  // namespace gable
