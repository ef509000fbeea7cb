#include "examples/cli/reconstruct_command.h"

#include <gable/engine/error.h>
#include <gable/engine/io/raster/raster_cache.h>
#include <gable/engine/reconstruct/tile/explanation.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "examples/cli/detector_options.h"
#include "examples/cli/model_outputs.h"
#include "examples/cli/progress.h"
#include "examples/cli/spread_option.h"
#include "examples/cli/tile_files.h"
#include "examples/cli/window_outputs.h"

namespace gable {
namespace {

/// What is kept of raster files, bytes: a few rows of a wide tile's blocks.
constexpr size_t kRasterCache = size_t{64} << 20;

struct ReconstructOptions {
  CommonOptions common;
  OutputOptions output;
  TileFileOptions tile;
  DetectorOptions detectors;
  bool no_scales = false, no_classical = false;
  std::string filter;
  std::vector<std::string> explain;  ///< ids
  std::optional<double> spread;
  bool no_join = false;
  bool no_cut = false;
  int window_cells = TileOptions().window_cells;
  bool resume = false;
};

void say(const ReconstructOptions& options, const std::string& line) {
  if (!options.common.quiet) std::cerr << line << std::endl;
}

/// How many buildings came out outside the grammar.
struct OutsideGrammar {
  size_t planes = 0;
  size_t extrusions = 0;
};

void say_spread(double spread, const ReconstructOptions& options) {
  if (spread == 0.0) return;
  char text[80];
  std::snprintf(text, sizeof(text), "surface heights are means over %.2f m, %s", spread,
                options.spread ? "as given" : "told by how walls are smeared");
  say(options, text);
}

void summarise(const TileSummary& summary, const OutsideGrammar& outside,
               const ReconstructOptions& options) {
  std::string line = options.output.models + ": " + std::to_string(summary.num_buildings) +
                     " buildings, " + std::to_string(outside.planes) +
                     " of them closed from planes, " + std::to_string(outside.extrusions) +
                     " extrusions";
  if (options.tile.footprints.empty()) {
    line += "; left out: " + std::to_string(summary.num_small) + " small pieces, " +
            std::to_string(summary.num_crown) + " parts of trees, " +
            std::to_string(summary.num_unexplained) + " small pieces that no house explains";
    if (!options.filter.empty()) {
      line += ", " + std::to_string(summary.num_far) + " away from footprints";
    }
  }
  say(options, line);
}

/// What is asked for about single buildings, and which of them there were.
class Explanations {
 public:
  explicit Explanations(const std::vector<std::string>& ids) : asked_(ids) {}

  void see(const TileBuilding& made) {
    if (std::find(asked_.begin(), asked_.end(), made.building.id) == asked_.end()) return;
    seen_.insert(made.building.id);
    text_ += (text_.empty() ? "" : "\n") + explain(made);
  }

  /// Throws Error where an id was asked for that no building has.
  void print() const {
    std::cout << text_ << std::flush;
    for (const std::string& id : asked_) {
      if (seen_.contains(id)) continue;
      throw Error(ExitCode::kBadInput, "--explain " + id +
                                           ": no building has this id; the models are written, "
                                           "and carry the ids there are");
    }
  }

 private:
  const std::vector<std::string>& asked_;
  std::set<std::string> seen_;
  std::string text_;
};

/// The folder of the output, or the nearest one above it that there is.
std::string scratch_beside(const std::string& output) {
  namespace fs = std::filesystem;
  std::error_code none;
  fs::path folder = fs::absolute(output, none);
  while (!fs::is_directory(folder, none) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder.string();
}

/// What is wrong with options that are each right by itself.
void require_sensible(const ReconstructOptions& options) {
  if (!options.resume) return;
  if (!names_a_folder(options.output.models)) {
    throw Error(ExitCode::kUsage, "--resume " + options.output.models +
                                      ": goes on with a folder of models alone; end -o with /");
  }
  if (!options.explain.empty()) {
    throw Error(ExitCode::kUsage,
                "--resume makes the missing windows alone, which --explain may not be about; "
                "leave one of them out");
  }
}

void run(ReconstructOptions options, const CLI::App& command, const CommandContext& context) {
  require_sensible(options);
  limit_raster_cache(kRasterCache);
  options.tile.scratch = scratch_beside(options.output.models);
  const TileFiles files(options.tile, [&](const std::string& line) { say(options, line); });
  TileInput input = files.input();
  FootprintFile filter;
  if (!options.filter.empty()) {
    filter = files.read_polygons(options.filter);
    input.filter = &filter.footprints;
  }

  ModelWriterOptions writer_options;
  writer_options.crs = files.dsm().crs();
  const Grid& grid = files.dsm().grid();
  writer_options.anchor << grid.center_of(grid.rows / 2, grid.cols / 2), 0.0;

  TileOptions tile_options;
  tile_options.scratch = options.tile.scratch;
  tile_options.window_cells = options.window_cells;
  tile_options.threads = options.common.num_threads();
  tile_options.detectors = options.detectors.folder();
  tile_options.building.scales = !options.no_scales;
  tile_options.building.choice.classical = !options.no_classical;
  if (tile_options.detectors.empty() && !options.detectors.none) {
    say(options, "no detectors are installed, so houses are searched in the heights alone");
  }
  tile_options.crop.spread = options.spread;
  tile_options.join_neighbours = !options.no_join;
  tile_options.cut_rows = !options.no_cut;
  std::optional<ModelOutputs> outputs;   // either these
  std::optional<WindowOutputs> windows;  // or these
  if (names_a_folder(options.output.models)) {
    WindowManifest manifest;
    manifest.version = GABLE_VERSION;
    manifest.inputs = manifest_inputs(options.tile, files, options.filter, tile_options.detectors);
    manifest.options = manifest_options(command);
    windows.emplace(options.output, options.resume, windows_of(input, tile_options),
                    std::move(manifest), writer_options);
    if (options.resume) {
      say(options, options.output.models + ": " + std::to_string(windows->num_done()) + " of " +
                       std::to_string(windows->num_windows()) + " windows are done already");
    }
  } else {
    outputs.emplace(options.output, writer_options);
    if (input.footprints) outputs->set_outlines(*input.footprints);
  }
  std::unique_ptr<Progress> progress;
  OutsideGrammar outside;
  Explanations explanations(options.explain);
  TileCallbacks callbacks;
  callbacks.begin_window = [&](int window, int num_windows, size_t num_buildings) {
    progress.reset();
    if (num_windows > 1) {
      say(options, "window " + std::to_string(window + 1) + " of " + std::to_string(num_windows));
    }
    progress = std::make_unique<Progress>("buildings", num_buildings,
                                          progress_style(options.common.quiet), std::cerr);
  };
  callbacks.made = [&] { progress->advance(); };
  callbacks.inspect = [&](const TileBuilding& made) {
    if (outputs) outputs->draw(made.index, made.building, made.image);
  };
  callbacks.deliver = [&](TileBuilding&& made) {
    explanations.see(made);
    outside.planes += made.building.status == BuildingStatus::kPlanes;
    outside.extrusions += made.building.status == BuildingStatus::kExtrusion;
    outputs ? outputs->append(std::move(made.building), std::move(made.model))
            : windows->append(std::move(made.building), made.model);
  };
  if (windows) windows->follow(&callbacks);
  TileSummary summary = reconstruct_tile(input, tile_options, context.stop, callbacks);
  progress.reset();
  if (summary.stopped && windows) {
    throw Error(ExitCode::kInterrupted, "interrupted; " + std::to_string(windows->num_done()) +
                                            " of " + std::to_string(windows->num_windows()) +
                                            " windows are done and kept, go on with --resume");
  }
  if (summary.stopped) throw Error(ExitCode::kInterrupted, "interrupted, nothing was written");
  say_spread(summary.spread, options);
  if (windows) {
    summary = windows->summary();
    outside.planes = windows->num_of(BuildingStatus::kPlanes);
    outside.extrusions = windows->num_of(BuildingStatus::kExtrusion);
  } else {
    outputs->close();
  }
  summarise(summary, outside, options);
  explanations.print();
}

}  // namespace

void add_reconstruct_command(CLI::App* app, const CommandContext& context) {
  auto options = std::make_shared<ReconstructOptions>();
  CLI::App* command = app->add_subcommand(
      "reconstruct", "Make house models from surface heights (metres, projected, any cell size)");
  CLI::Option* footprints = add_tile_set_options(command, &options->tile);
  command
      ->add_option("--near-footprints", options->filter,
                   "Find buildings in the heights, but keep only those inside an outline's "
                   "bounding box enlarged to twice its size")
      ->type_name("FILE")
      ->excludes(footprints);
  add_spread_option(command, &options->spread);
  add_detector_options(command, &options->detectors);
  command->add_flag("--no-scales", options->no_scales,
                    "Take no first values from the planes at the buildings' structural scales");
  command->add_flag("--no-classical", options->no_classical,
                    "Do not search for first values in the heights; what no other source explains "
                    "becomes an extrusion");
  command
      ->add_option("--explain", options->explain,
                   "Print how the house of the building with this id was chosen, and why the "
                   "building came out as it did; may be given several times")
      ->type_name("ID")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_flag("--no-cut", options->no_cut,
                    "Leave rows of houses that are found in the heights in one piece");
  command->add_flag("--no-join", options->no_join,
                    "Leave houses that share a party wall as each was fitted by itself, instead of "
                    "refining them together");
  command
      ->add_option("--window", options->window_cells,
                   "Cells along a side of the windows that are worked on one after the other; "
                   "memory grows with its square")
      ->type_name("CELLS")
      ->check(CLI::Range(64, 32768))
      ->capture_default_str();
  command->add_flag("--resume", options->resume,
                    "Go on with a folder of models that was not finished: windows that are done "
                    "are kept");
  add_output_options(command, &options->output);
  command->get_option("--output")
      ->description(
          "Models: .city.jsonl (CityJSONSeq) or .city.json (CityJSON), or a folder, DIR/, for a "
          "CityJSONSeq per window and manifest.json");
  add_common_options(command, &options->common);
  command->callback([options, command, context] { run(*options, *command, context); });
}

}  // namespace gable
