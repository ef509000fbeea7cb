#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gable {

/// Where the learned detectors come from.
struct DetectorOptions {
  std::string folder_given;
  bool none = false;

  /// The folder of the networks, or "" to work without: the one given, else the installed one.
  std::string folder() const;
};

/// Adds --detectors and --no-detectors to a command.
void add_detector_options(CLI::App* command, DetectorOptions* options);

}  // namespace gable
