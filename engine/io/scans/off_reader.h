#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads an OFF file (Geomview's object file format, ascii): OFF, COFF, NOFF, STOFF and their
/// combinations, comments, counts on the line of the keyword or after it. Read are points, normals
/// and facets; colours and texture coordinates are not. Errors as `read_scan_file`; `path` is for
/// messages.
ScanFile read_off(std::string_view bytes, const std::string& path);

}  // namespace gable
