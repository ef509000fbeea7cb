#pragma once

#include <gable/engine/error.h>
#include <gable/engine/io/scans/scan_file.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace gable {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "a reader broke its word: %s\n", what);
  std::abort();
}

/// What every reader promises of a scan.
inline void check_scan(const Scan& scan) {
  require(!scan.points.empty(), "there are points");
  for (const Eigen::Vector3d& point : scan.points) require(point.allFinite(), "points are finite");
  require(scan.normals.empty() || scan.normals.size() == scan.points.size(), "normals fit");
  for (const Eigen::Vector3f& normal : scan.normals) {
    require(normal.isZero(0.0f) || std::abs(normal.norm() - 1.0f) < 1e-5f, "normals are unit");
  }
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    require(scan.facets[f].size() >= 3, "facets have three corners");
    for (const int corner : scan.facets[f]) {
      require(corner >= 0 && static_cast<size_t>(corner) < scan.points.size(),
              "corners are points");
    }
  }
  for (const auto& [name, values] : scan.labels) {
    require(values.size() == scan.num_elements(), "labels fit");
    for (const int value : values) require(value >= -1, "labels are numbers or none");
  }
}

/// Gives a reader some bytes: it must deliver a sound scan or refuse them in one line.
template <typename Reader>
int check_reader(const Reader& reader, const unsigned char* data, size_t size) {
  try {
    check_scan(reader({reinterpret_cast<const char*>(data), size}, "scan").scan);
  } catch (const Error& error) {
    const std::string_view line = error.what();
    require(error.code() == ExitCode::kBadInput, "what it refuses is bad input");
    require(line.starts_with("scan: ") && line.find("; ") != line.npos, "errors name a remedy");
    for (const char c : line) require(c >= ' ' && c <= '~', "errors are one printable line");
  }
  return 0;
}

}  // namespace gable
