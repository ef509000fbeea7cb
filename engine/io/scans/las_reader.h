#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads a LAS file, 1.0 to 1.4, point formats 0 to 10 (ASPRS LAS specification 1.4 R15, tables 3
/// and 7 ff.): coordinates with scale and offset, and the classification as the label "class".
/// Errors as `read_scan_file`; also where the points are compressed (LAZ). `path` is for messages.
ScanFile read_las(std::string_view bytes, const std::string& path);

}  // namespace gable
