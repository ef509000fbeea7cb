#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads a PCD file (Point Cloud Library, versions .5 to .7) with ascii, binary (little-endian) or
/// binary_compressed data: fields x y z and, where all three are there, normal_x normal_y normal_z;
/// integer fields other than rgb and rgba become labels. Points of organised clouds that have no
/// measurement (NaN) are skipped and counted. Errors as `read_scan_file`; `path` is for messages.
ScanFile read_pcd(std::string_view bytes, const std::string& path);

}  // namespace gable
