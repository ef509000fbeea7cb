#include <gable/engine/error.h>
#include <gable/engine/io/model_folder.h>

#include <cstdlib>
#include <filesystem>
#include <set>

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".scales";
constexpr char kDetectors[] = "detectors";

}  // namespace

std::vector<std::string> model_folders() {
  std::error_code none;  // a folder that cannot be looked at is no folder
  std::vector<fs::path> candidates;
  if (const char* folder = std::getenv("GABLE_MODELS"); folder && *folder) {
    candidates.push_back(folder);
  }
  candidates.push_back(GABLE_SOURCE_MODELS);
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  if (!program.empty()) candidates.push_back(program.parent_path() / GABLE_MODELS_FROM_PROGRAM);
  candidates.push_back(GABLE_INSTALLED_MODELS);
  std::vector<std::string> folders;
  for (const fs::path& candidate : candidates) {
    if (fs::is_directory(candidate, none)) {
      folders.push_back(candidate.lexically_normal().string());
    }
  }
  return folders;
}

std::vector<std::string> scale_model_names() {
  std::set<std::string> names;
  for (const std::string& folder : model_folders()) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "scales", none)) {
      if (entry.path().extension() == kExtension) names.insert(entry.path().stem().string());
    }
  }
  return {names.begin(), names.end()};
}

std::string find_scale_model(const std::string& model) {
  if (model.find('/') != std::string::npos || fs::path(model).extension() == kExtension) {
    return model;
  }
  for (const std::string& folder : model_folders()) {
    const fs::path file = fs::path(folder) / "scales" / (model + kExtension);
    std::error_code none;
    if (fs::is_regular_file(file, none)) return file.string();
  }
  std::string known;
  for (const std::string& name : scale_model_names()) known += (known.empty() ? "" : ", ") + name;
  throw Error(ExitCode::kNoInput,
              model + ": no such model; " +
                  (known.empty() ? "none is installed, set GABLE_MODELS to the folder of models"
                                 : "known are " + known) +
                  ", or give a file that ends with " + kExtension);
}

std::string installed_detector_models() {
  for (const std::string& folder : model_folders()) {
    const fs::path detectors = fs::path(folder) / kDetectors;
    std::error_code none;
    if (fs::is_directory(detectors, none)) return detectors.string();
  }
  return "";
}

std::string find_detector_models() {
  if (std::string detectors = installed_detector_models(); !detectors.empty()) return detectors;
  const std::vector<std::string> folders = model_folders();
  const std::string looked_in = folders.empty() ? "models" : folders.front();
  throw Error(ExitCode::kNoInput,
              (fs::path(looked_in) / kDetectors).string() +
                  ": no detectors are installed here; set GABLE_MODELS to a folder that has them "
                  "in detectors/");
}

}  // namespace gable
