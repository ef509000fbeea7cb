#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads a Wavefront OBJ file: v, vn and f with corners a, a/b, a//c or a/b/c and indices from 1,
/// or negative ones that count back from the last point. A point's normal is the mean of those of
/// its corners; without facets, the normals are those of the points where there are as many of
/// both. Everything else is ignored. Errors as `read_scan_file`; `path` is for messages.
ScanFile read_obj(std::string_view bytes, const std::string& path);

}  // namespace gable
