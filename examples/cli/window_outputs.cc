#include "examples/cli/window_outputs.h"

#include <gable/engine/error.h>
#include <gable/engine/io/content_hash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace gable {
namespace {

namespace fs = std::filesystem;

/// Options whose files are among the inputs, or that leave the models as they are.
constexpr std::array<std::string_view, 12> kNotRecorded = {
    "dsm",         "--dtm",     "--dtm-dir", "--footprints", "--near-footprints", "--detectors",
    "-o,--output", "-h,--help", "--threads", "--quiet",      "--resume",          "--explain"};

ManifestInput input_of(const std::string& role, const std::string& path) {
  ManifestInput input{role, fs::path(path).filename().string(), 0, ""};
  if (path.starts_with("/vsi")) return input;  // GDAL's own files are known by their name alone
  const FileIdentity identity = identity_of_file(path);
  input.bytes = identity.bytes;
  input.hash = identity.hash;
  return input;
}

std::string window_name(const TileWindow& window) {
  char text[32];
  std::snprintf(text, sizeof text, "%04d_%04d", window.row, window.col);
  return text;
}

WindowManifest with_windows(WindowManifest manifest, const std::vector<TileWindow>& windows) {
  for (const TileWindow& window : windows) {
    manifest.windows.emplace_back().name = window_name(window);
  }
  return manifest;
}

const std::string& checked_folder(const OutputOptions& options) {
  for (const auto& [option, value] : {std::pair{"--obj", &options.obj},
                                      {"--glb", &options.glb},
                                      {"--kml", &options.kml},
                                      {"--gpkg", &options.gpkg},
                                      {"--report", &options.report}}) {
    if (value->empty()) continue;
    throw Error(ExitCode::kUsage,
                std::string(option) + " " + *value +
                    ": there is none beside a folder of models; name a file with -o, which may be "
                    "made of several tiles as well: -o models.city.jsonl");
  }
  if (options.slabs.wanted()) {
    throw Error(ExitCode::kUsage,
                "--thickness: roofs as slabs end at neighbours that other windows hold; name a "
                "file with -o, which may be made of several tiles as well: -o models.city.jsonl");
  }
  return options.models;
}

}  // namespace

bool names_a_folder(const std::string& models) {
  std::error_code none;
  return models.ends_with('/') || fs::is_directory(models, none) ||
         (!models.empty() && !fs::path(models).has_extension());
}

std::vector<ManifestInput> manifest_inputs(const TileFileOptions& options, const TileFiles& files,
                                           const std::string& filter,
                                           const std::string& detectors) {
  std::vector<ManifestInput> inputs;
  for (const std::string& path : options.surfaces()) inputs.push_back(input_of("surface", path));
  for (const std::string& path : files.terrain_files()) {
    inputs.push_back(input_of("terrain", path));
  }
  if (!options.footprints.empty()) inputs.push_back(input_of("footprints", options.footprints));
  if (!filter.empty()) inputs.push_back(input_of("footprints nearby", filter));
  if (detectors.empty()) return inputs;
  std::vector<std::string> networks;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(detectors, none)) {
    if (entry.path().extension() == ".onnx") networks.push_back(entry.path().string());
  }
  std::sort(networks.begin(), networks.end());
  for (const std::string& path : networks) {
    ManifestInput input = input_of("network", path);
    input.hash = hash_of_file(path);  // what differs between trainings may lie in the middle
    inputs.push_back(input);
  }
  return inputs;
}

std::vector<std::pair<std::string, std::string>> manifest_options(const CLI::App& command) {
  std::vector<std::pair<std::string, std::string>> options;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name(false, true);
    if (std::find(kNotRecorded.begin(), kNotRecorded.end(), name) != kNotRecorded.end()) continue;
    std::string value = option->get_default_str();
    if (option->count() > 0) {
      value.clear();
      for (const std::string& result : option->results()) {
        value += (value.empty() ? "" : " ") + result;
      }
    }
    if (!value.empty()) options.emplace_back(name, value);
  }
  return options;
}

WindowOutputs::WindowOutputs(const OutputOptions& options, bool resume,
                             const std::vector<TileWindow>& windows, WindowManifest manifest,
                             const ModelWriterOptions& writer_options)
    : times_(options.times),
      folder_(checked_folder(options), with_windows(std::move(manifest), windows), writer_options,
              resume) {}

size_t WindowOutputs::num_done() const {
  const auto& windows = folder_.manifest().windows;
  return static_cast<size_t>(std::count_if(windows.begin(), windows.end(),
                                           [](const ManifestWindow& w) { return w.done; }));
}

void WindowOutputs::follow(TileCallbacks* callbacks) {
  callbacks->wants_window = [this](const TileWindow& window) {
    window_ = static_cast<size_t>(window.index);
    return !folder_.is_done(window_);
  };
  callbacks->end_window = [this](const TileWindow&, const TileSummary& summary) {
    ManifestWindow counts;
    counts.small = summary.num_small;
    counts.crowns = summary.num_crown;
    counts.far = summary.num_far;
    counts.unexplained = summary.num_unexplained;
    folder_.finish(window_, counts);
  };
}

void WindowOutputs::append(Building building, const BuildingModel& model) {
  if (!times_) building.quality.time_ms = -1.0;
  folder_.append(window_, building, model);
}

TileSummary WindowOutputs::summary() const {
  TileSummary summary;
  for (const ManifestWindow& window : folder_.manifest().windows) {
    summary.num_buildings += num_buildings(window);
    summary.num_small += window.small;
    summary.num_crown += window.crowns;
    summary.num_far += window.far;
    summary.num_unexplained += window.unexplained;
  }
  return summary;
}

size_t WindowOutputs::num_of(BuildingStatus status) const {
  size_t count = 0;
  for (const ManifestWindow& window : folder_.manifest().windows) {
    const auto found = window.buildings.find(building_status_name(status));
    if (found != window.buildings.end()) count += found->second;
  }
  return count;
}

}  // namespace gable
