#include "examples/cli/new_folder.h"

#include <gable/engine/error.h>

#include <filesystem>
#include <system_error>

namespace gable {

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw Error(ExitCode::kCannotWrite, folder + ": the folder cannot be made" +
                                            (error ? " (" + error.message() + ")" : std::string()) +
                                            "; name another with -o");
  }
}

}  // namespace gable
