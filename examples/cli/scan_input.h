#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <vector>

namespace gable {

/// What of a scan file could not be used, as one line for people; empty where nothing was skipped.
std::string skipped_line(const std::string& path, const ScanFile& file);

/// The scans among files and folders: files as given, of folders all files with a readable
/// extension, sorted by name; each once. Throws Error (kNoInput) where a path does not exist or a
/// folder has no scans.
std::vector<std::string> scan_files(const std::vector<std::string>& paths);

}  // namespace gable
