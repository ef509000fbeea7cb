#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace gable {

/// An input file, by what it holds and not by where it lies.
struct ManifestInput {
  std::string role;  ///< "surface", "terrain", "footprints", ...
  std::string name;  ///< without folders
  uint64_t bytes = 0;
  std::string hash;  ///< see FileIdentity
  bool operator==(const ManifestInput&) const = default;
};

/// What is known of a window's models.
struct ManifestWindow {
  std::string name;   ///< "0003_0007": its row and column, from the north-west
  bool done = false;  ///< what follows holds where it is
  std::map<std::string, size_t> buildings;  ///< how many there are of each status, by its name
  int small = 0;                            ///< high pieces that were too small to be houses
  int crowns = 0;                           ///< high pieces that were parts of trees
  int far = 0;                              ///< houses away from footprints
  int unexplained = 0;                      ///< small pieces that no house explains
  std::string file;                         ///< in the folder; empty where there are no buildings
  std::string hash;                         ///< of the file's bytes, see ContentHash
};

/// What a folder of models was made of, and how far it is.
struct WindowManifest {
  std::string version;  ///< of the program
  std::vector<ManifestInput> inputs;
  std::vector<std::pair<std::string, std::string>> options;  ///< that change the result
  std::vector<ManifestWindow> windows;                       ///< in the order of work
};

/// How many buildings a window has.
size_t num_buildings(const ManifestWindow& window);

/// As JSON. The same manifest gives the same bytes.
std::string manifest_text(const WindowManifest& manifest);

/// Reads it back. Throws Error: kNoInput where the file does not exist, kBadInput where it is no
/// manifest.
WindowManifest read_manifest(const std::string& path);

/// Empty where two manifests are of the same program, inputs, options and windows (done or not);
/// otherwise what differs, for people: "the option gsd is 0.25, but was 0.5".
std::string difference(const WindowManifest& now, const WindowManifest& before);

}  // namespace gable
