#include "examples/cli/annotate_command.h"

#include <gable/engine/drawing/report_file.h>
#include <gable/engine/error.h>
#include <gable/engine/io/answers/annotations_file.h>
#include <gable/engine/io/answers/answers_file.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/staged_folder.h>
#include <gable/engine/reconstruct/annotate/annotated_from_answer.h>
#include <gable/engine/reconstruct/annotate/annotation_panel.h>
#include <gable/engine/reconstruct/annotate/annotation_sheets.h>
#include <gable/engine/reconstruct/annotate/proposed_answer.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "examples/cli/detector_options.h"
#include "examples/cli/extent_option.h"
#include "examples/cli/progress.h"
#include "examples/cli/tile_files.h"

namespace gable {
namespace {

namespace fs = std::filesystem;

struct AnnotateOptions {
  CommonOptions common;
  TileFileOptions tile;
  std::string output, apply, show;
  ExtentOption extent;
  AnnotationSheetOptions sheets;
  DetectorOptions detectors;
};

void say(const AnnotateOptions& options, const std::string& line) {
  if (!options.common.quiet) std::cerr << line << std::endl;
}

std::string epsg_text(const Crs& crs) {
  return crs.epsg > 0 ? "EPSG:" + std::to_string(crs.epsg) : "";
}

/// A file's path below GABLE_DATA; where it does not lie there, its name; empty where there is
/// none.
std::string name_in_data(const std::string& file) {
  if (file.empty()) return "";
  const char* data = std::getenv("GABLE_DATA");
  std::error_code none;
  if (data != nullptr) {
    const fs::path below = fs::weakly_canonical(file, none)
                               .lexically_relative(fs::weakly_canonical(fs::path(data), none));
    if (!below.empty() && *below.begin() != "..") return below.generic_string();
  }
  return fs::path(file).filename().string();
}

HeightRaster heights_around(const HeightSource& dsm, const CropFrame& frame) {
  const Grid grid = grid_around(frame, dsm.grid());
  if (grid.rows <= 0 || grid.cols <= 0) return {};
  const Eigen::Vector2d first = dsm.grid().cell_of(grid.center_of(0, 0));
  return dsm.read(static_cast<int>(std::lround(first.x())),
                  static_cast<int>(std::lround(first.y())), grid.rows, grid.cols);
}

std::string kind_text(const HouseAnswer& answer) {
  std::string text(foundation_name(answer.foundation));
  for (const RoofType roof : answer.roofs) text += " " + std::string(roof_type_name(roof));
  return text;
}

std::string title_of(size_t index, const HouseAnswer& answer) {
  std::string title = "#" + std::to_string(index) + "  " + answer.id + "  " + kind_text(answer);
  if (answer.confidence) title += "  " + std::string(confidence_name(*answer.confidence));
  return title;
}

/// What somebody has already reviewed, by id.
std::map<std::string, HouseAnswer> reviewed_before(const std::string& path,
                                                   const HouseAnswers& anew) {
  std::map<std::string, HouseAnswer> reviewed;
  std::error_code none;
  if (!fs::exists(path, none)) return reviewed;
  HouseAnswers before = read_answers(path);
  if (before.source.tile != anew.source.tile) {
    throw Error(ExitCode::kBadInput, path + ": holds answers for " + before.source.tile + ", not " +
                                         anew.source.tile + "; give another folder");
  }
  for (HouseAnswer& house : before.houses) {
    if (house.reviewed) reviewed.emplace(house.id, std::move(house));
  }
  return reviewed;
}

AnnotationSheets sheets_into(StagedFolder* folder, const AnnotateOptions& options) {
  return AnnotationSheets(options.sheets, [folder](const std::string& name, const cv::Mat& sheet) {
    write_file_atomically(folder->path(name), png_bytes(sheet));
  });
}

void propose(const AnnotateOptions& options, const CommandContext& context) {
  const TileFiles files(options.tile, [&](const std::string& line) { say(options, line); });
  const HeightSource& dsm = files.dsm();
  HouseAnswers answers{
      {name_in_data(options.tile.dsm), name_in_data(options.tile.dtm),
       name_in_data(options.tile.footprints), epsg_text(dsm.crs()), dsm.grid().gsd},
      {}};
  const std::string list = (fs::path(options.output) / "answers.json").string();
  const std::map<std::string, HouseAnswer> before = reviewed_before(list, answers);
  StagedFolder staged(options.output);
  AnnotationSheets sheets = sheets_into(&staged, options);

  std::unique_ptr<Progress> progress;
  TileCallbacks callbacks;
  callbacks.begin_window = [&](int, int, size_t num_buildings) {
    progress = std::make_unique<Progress>("buildings", num_buildings,
                                          progress_style(options.common.quiet), std::cerr);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    progress->advance();
    if (!options.extent.holds(made.image.origin.head<2>())) return;
    const auto old = before.find(made.building.id);
    HouseAnswer answer =
        old != before.end() ? old->second : proposed_answer(made.building, made.image);
    answer.sheet = annotation_sheet_name(answers.houses.size(), options.sheets);
    const HeightRaster heights = heights_around(dsm, answer.frame);
    sheets.add(draw_annotation_panel({&answer, &heights, made.image.origin.z(), &made.image,
                                      title_of(answers.houses.size() + 1, answer)}));
    answers.houses.push_back(std::move(answer));
  };
  TileOptions tile_options;
  tile_options.threads = options.common.num_threads();
  tile_options.detectors = options.detectors.folder();
  const TileSummary summary =
      reconstruct_tile(files.input(), tile_options, context.stop, callbacks);
  progress.reset();
  if (summary.stopped) throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  if (answers.houses.empty()) {
    throw Error(ExitCode::kBadInput,
                options.tile.dsm + ": no building there; check --dtm, --footprints and --extent");
  }
  sheets.finish();
  write_answers(staged.path("answers.json"), answers);
  staged.commit();
  say(options, list + ": " + std::to_string(answers.houses.size()) +
                   " buildings; correct them by the sheets, set \"reviewed\" and \"confidence\"");
}

void apply(const AnnotateOptions& options) {
  const HouseAnswers answers = read_answers(options.apply);
  AnnotatedTile tile{answers.source, {}};
  for (const HouseAnswer& answer : answers.houses) {
    if (answer.reviewed) tile.houses.push_back(annotated_from_answer(answer, options.apply));
  }
  if (tile.houses.empty()) {
    throw Error(ExitCode::kBadInput, options.apply + ": none of its " +
                                         std::to_string(answers.houses.size()) +
                                         " buildings is reviewed; set \"reviewed\" to true");
  }
  write_annotations(options.output, tile);
  say(options, options.output + ": " + std::to_string(tile.houses.size()) + " of " +
                   std::to_string(answers.houses.size()) + " buildings");
}

void show(const AnnotateOptions& options) {
  const AnnotatedTile tile = read_annotations(options.show);
  const RasterFile dsm(options.tile.dsm, {options.tile.crs});
  const std::string& crs = tile.source.crs;
  if (!crs.empty() && dsm.crs().epsg != 0 && crs != epsg_text(dsm.crs())) {
    throw Error(ExitCode::kBadInput, options.show + ": is in " + crs + ", but " + options.tile.dsm +
                                         " in " + epsg_text(dsm.crs()) + "; give its own raster");
  }
  StagedFolder staged(options.output);
  AnnotationSheets sheets = sheets_into(&staged, options);
  size_t shown = 0;
  for (const AnnotatedHouse& house : tile.houses) {
    if (!options.extent.holds(house.center)) continue;
    const HouseAnswer answer = answer_from_annotated(house);
    const HeightRaster heights = heights_around(dsm, answer.frame);
    if (heights.values.empty()) {
      throw Error(ExitCode::kBadInput, options.show + ": " + house.id + " lies outside " +
                                           options.tile.dsm + "; give the raster " +
                                           tile.source.tile);
    }
    sheets.add(draw_annotation_panel({&answer, &heights, low_height(heights, answer.frame), nullptr,
                                      title_of(++shown, answer)}));
  }
  if (shown == 0) {
    throw Error(ExitCode::kBadInput, options.show + ": no house there; check --extent");
  }
  sheets.finish();
  staged.commit();
  say(options, options.output + ": " + std::to_string(shown) + " buildings");
}

void run(const AnnotateOptions& options, const CommandContext& context) {
  if (!options.apply.empty()) return apply(options);
  if (options.tile.dsm.empty())
    throw Error(ExitCode::kUsage, "annotate wants DSM (see gable --help)");
  options.show.empty() ? propose(options, context) : show(options);
}

}  // namespace

void add_annotate_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<AnnotateOptions>();
  CLI::App* command = app->add_subcommand(
      "annotate", "Draw sheets of real buildings, and propose what they are, to be corrected");
  add_tile_file_options(command, &options->tile);
  CLI::Option* dsm = command->get_option("dsm")->required(false);
  command
      ->add_option("-o,--output", options->output,
                   "Folder for the sheets and answers.json; with --apply the annotations (JSON)")
      ->type_name("DIR")
      ->required();
  auto* apply_option =
      command->add_option("--apply", options->apply,
                          "Check the reviewed buildings of this answers.json and write them to -o");
  apply_option->type_name("FILE")->excludes(dsm);
  command
      ->add_option("--show", options->show,
                   "Draw sheets of these annotations over DSM instead of making proposals")
      ->type_name("FILE")
      ->excludes(apply_option);
  add_extent_option(command, &options->extent);
  command
      ->add_option("--columns", options->sheets.columns, "Buildings beside each other on a sheet")
      ->type_name("N")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  command->add_option("--rows", options->sheets.rows, "Rows of buildings on a sheet")
      ->type_name("N")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  add_detector_options(command, &options->detectors);
  add_common_options(command, &options->common);
  command->callback([options, context] { run(*options, context); });
}

}  // namespace gable
