#include "examples/cli/scan_input.h"

#include <gable/engine/error.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace gable {
namespace {

namespace fs = std::filesystem;

std::string counted(size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::string skipped_line(const std::string& path, const ScanFile& file) {
  std::string skipped;
  if (file.skipped_points > 0) skipped = counted(file.skipped_points, "point") + " not finite";
  if (file.skipped_facets > 0) {
    skipped += (skipped.empty() ? "" : ", ") + counted(file.skipped_facets, "facet") +
               " with such or too few corners";
  }
  return skipped.empty() ? "" : path + ": skipped " + skipped;
}

std::vector<std::string> scan_files(const std::vector<std::string>& paths) {
  std::vector<std::string> files;
  for (const std::string& path : paths) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
      if (!fs::exists(path, error)) throw Error(ExitCode::kNoInput, path + ": no such file");
      files.push_back(path);
      continue;
    }
    const size_t begin = files.size();
    for (const auto& entry : fs::directory_iterator(path, error)) {
      if (!entry.is_directory() && has_scan_extension(entry.path().string())) {
        files.push_back(entry.path().string());
      }
    }
    if (error) throw Error(ExitCode::kNoInput, path + ": " + error.message());
    if (files.size() == begin) {
      throw Error(ExitCode::kNoInput, path + ": holds no scans; give a folder of scans");
    }
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(begin), files.end());
  }
  std::set<std::string> seen;
  std::erase_if(files, [&](const std::string& file) {
    return !seen.insert(fs::path(file).lexically_normal().string()).second;
  });
  return files;
}

}  // namespace gable
