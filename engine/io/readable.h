#pragma once

#include <string>

namespace gable {

/// Checks that a file (or one of GDAL's virtual files) exists and may be read. Throws Error
/// (kNoInput).
void require_readable(const std::string& path);

}  // namespace gable
