#pragma once

#include <gable/engine/io/scans/las_points.h>
#include <gable/engine/io/scans/scan_file.h>

#include <functional>
#include <string>
#include <string_view>

namespace gable {

/// Reads a LAZ file (or a LAS file), where gable is built with LASzip; otherwise throws Error
/// (kBadInput) that names the remedy. What is read is what `read_las` reads. Errors as
/// `read_scan_file`.
ScanFile read_laz(std::string_view bytes, const std::string& path);

/// Calls `visit` with every point of a LAZ file, in the order of the file. Errors as `read_laz`.
void visit_laz_points(std::string_view bytes, const std::string& path,
                      const std::function<void(const LasPoint&)>& visit);

}  // namespace gable
