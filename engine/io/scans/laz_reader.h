#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Reads a LAZ file (or a LAS file), where gable is built with LASzip; otherwise throws Error
/// (kBadInput) that names the remedy. What is read is what `read_las` reads. Errors as
/// `read_scan_file`.
ScanFile read_laz(std::string_view bytes, const std::string& path);

}  // namespace gable
