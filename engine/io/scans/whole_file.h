#pragma once

#include <string>

namespace gable {

/// The bytes of a whole file. Throws Error (kNoInput) where it does not exist or cannot be read.
std::string read_whole_file(const std::string& path);

}  // namespace gable
