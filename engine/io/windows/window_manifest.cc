#include <gable/engine/error.h>
#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/scans/whole_file.h>
#include <gable/engine/io/windows/window_manifest.h>

#include <algorithm>

namespace gable {
namespace {

constexpr const char* kKind = "gable models by window";

Json json_of(const ManifestWindow& window) {
  Json json;
  json["window"] = window.name;
  json["done"] = window.done;
  if (!window.done) return json;
  json["buildings"] = window.buildings;
  json["small_pieces"] = window.small;
  json["parts_of_trees"] = window.crowns;
  json["away_from_footprints"] = window.far;
  json["unexplained_pieces"] = window.unexplained;
  if (window.file.empty()) return json;
  json["file"] = window.file;
  json["fnv1a64"] = window.hash;
  return json;
}

ManifestWindow window_of(const Json& json) {
  ManifestWindow window;
  window.name = json.at("window").get<std::string>();
  window.done = json.at("done").get<bool>();
  if (!window.done) return window;
  for (const auto& [status, count] : json.at("buildings").items()) {
    window.buildings[status] = count.get<size_t>();
  }
  window.small = json.at("small_pieces").get<int>();
  window.crowns = json.at("parts_of_trees").get<int>();
  window.far = json.at("away_from_footprints").get<int>();
  window.unexplained = json.at("unexplained_pieces").get<int>();
  if (!json.contains("file")) return window;
  window.file = json.at("file").get<std::string>();
  window.hash = json.at("fnv1a64").get<std::string>();
  return window;
}

Json json_of(const ManifestInput& input) {
  Json json;
  json["role"] = input.role;
  json["name"] = input.name;
  json["bytes"] = input.bytes;
  json["fnv1a64_of_ends"] = input.hash;
  return json;
}

/// A list with one item per line, so that people and `diff` can read it.
template <typename List>
void append_lines(const List& list, std::string* text) {
  *text += "[";
  for (size_t i = 0; i < list.size(); ++i) {
    *text += (i == 0 ? "\n" : ",\n") + dump_json(json_of(list[i]));
  }
  *text += "\n]";
}

}  // namespace

size_t num_buildings(const ManifestWindow& window) {
  size_t sum = 0;
  for (const auto& [status, count] : window.buildings) sum += count;
  return sum;
}

std::string manifest_text(const WindowManifest& manifest) {
  Json options = Json::object();
  for (const auto& [name, value] : manifest.options) options[name] = value;
  std::string text = "{\"kind\":" + dump_json(kKind) +
                     ",\n\"version\":" + dump_json(manifest.version) + ",\n\"inputs\":";
  append_lines(manifest.inputs, &text);
  text += ",\n\"options\":" + dump_json(options) + ",\n\"windows\":";
  append_lines(manifest.windows, &text);
  return text + "}\n";
}

WindowManifest read_manifest(const std::string& path) {
  const std::string bytes = read_whole_file(path);
  WindowManifest manifest;
  try {
    const Json json = Json::parse(bytes);
    if (json.at("kind") != kKind) throw Error(ExitCode::kBadInput, "");
    manifest.version = json.at("version").get<std::string>();
    for (const Json& input : json.at("inputs")) {
      manifest.inputs.push_back(
          {input.at("role").get<std::string>(), input.at("name").get<std::string>(),
           input.at("bytes").get<uint64_t>(), input.at("fnv1a64_of_ends").get<std::string>()});
    }
    for (const auto& [name, value] : json.at("options").items()) {
      manifest.options.emplace_back(name, value.get<std::string>());
    }
    for (const Json& window : json.at("windows")) manifest.windows.push_back(window_of(window));
  } catch (const std::exception&) {
    throw Error(ExitCode::kBadInput,
                path + ": is no manifest of models; remove it, or give another folder with -o");
  }
  return manifest;
}

std::string difference(const WindowManifest& now, const WindowManifest& before) {
  if (now.version != before.version) {
    return "gable is " + now.version + ", but was " + before.version;
  }
  for (size_t i = 0; i < std::max(now.inputs.size(), before.inputs.size()); ++i) {
    if (i >= before.inputs.size()) {
      return "the " + now.inputs[i].role + " " + now.inputs[i].name + " is new";
    }
    const ManifestInput& was = before.inputs[i];
    if (i >= now.inputs.size()) return "the " + was.role + " " + was.name + " is missing";
    const ManifestInput& is = now.inputs[i];
    if (is == was) continue;
    if (is.role == was.role && is.name == was.name) {
      return "the " + is.role + " " + is.name + " has changed";
    }
    return "the " + is.role + " " + is.name + " stands where the " + was.role + " " + was.name +
           " was";
  }
  for (size_t i = 0; i < std::max(now.options.size(), before.options.size()); ++i) {
    if (i < now.options.size() && i < before.options.size() &&
        now.options[i] == before.options[i]) {
      continue;
    }
    if (i < now.options.size() && i < before.options.size() &&
        now.options[i].first == before.options[i].first) {
      return "the option " + now.options[i].first + " is \"" + now.options[i].second +
             "\", but was \"" + before.options[i].second + "\"";
    }
    return "the options are others";
  }
  const bool same_windows = std::equal(
      now.windows.begin(), now.windows.end(), before.windows.begin(), before.windows.end(),
      [](const ManifestWindow& a, const ManifestWindow& b) { return a.name == b.name; });
  return same_windows ? "" : "the windows are others";
}

}  // namespace gable
