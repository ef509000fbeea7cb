#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads a PLY file (Turk 1994), ascii or binary of either byte order, properties of any type:
/// element "vertex" with x y z and, where all three are there, nx ny nz; element "face" with a list
/// "vertex_indices" or "vertex_index". Integer properties other than colours become labels: of the
/// faces where there are faces, else of the vertices. Other elements and properties are skipped.
/// Errors as `read_scan_file`; `path` is for messages.
ScanFile read_ply(std::string_view bytes, const std::string& path);

}  // namespace gable
