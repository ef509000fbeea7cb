#include "examples/cli/detector_options.h"

#include <gable/engine/io/model_folder.h>

namespace gable {

std::string DetectorOptions::folder() const {
  if (none) return "";
  return folder_given.empty() ? installed_detector_models() : folder_given;
}

void add_detector_options(CLI::App* command, DetectorOptions* options) {
  CLI::Option* folder =
      command->add_option("--detectors", options->folder_given,
                          "Folder of learned detectors (house.onnx, roof.onnx, azimuth.onnx) "
                          "instead of the installed ones");
  folder->type_name("DIR")->check([](const std::string& value) {
    return value.empty() ? std::string("names no folder") : std::string();
  });
  command
      ->add_flag("--no-detectors", options->none,
                 "Search for first values in the heights alone, without any learned model")
      ->excludes(folder);
}

}  // namespace gable
