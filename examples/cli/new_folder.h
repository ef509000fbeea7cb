#pragma once

#include <string>

namespace gable {

/// Makes an output folder where it is missing. Throws Error (kCannotWrite).
void make_folder(const std::string& folder);

}  // namespace gable
