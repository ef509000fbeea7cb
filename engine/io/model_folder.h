#pragma once

#include <string>
#include <vector>

namespace gable {

/// Where trained models are looked for, in this order; folders that do not exist are left out:
/// the environment variable GABLE_MODELS, `models` of the source tree that the library was built
/// from, share/gable/models beside the running program's bin, and the same below the install
/// prefix. Scale models lie in `scales` below them, detectors in `detectors`.
std::vector<std::string> model_folders();

/// The names of the scale models in model_folders(), sorted, each once.
std::vector<std::string> scale_model_names();

/// The file of a scale model: `model` itself if it has a '/' or ends with .scales, whether it
/// exists or not; otherwise the first file scales/<model>.scales in model_folders(). Throws Error
/// (kNoInput) for a name that is in none, with the names that are.
std::string find_scale_model(const std::string& model);

/// The folder of the detectors' networks (see engine/detectors/detector_nets.h): the first folder
/// `detectors` in model_folders(). Throws Error (kNoInput) where there is none.
std::string find_detector_models();

/// The same, or "" where there is none.
std::string installed_detector_models();

}  // namespace gable
