#pragma once

#include <gable/engine/io/scans/scan_file.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {

/// Fails where a scan that was read is not the one expected; normals to float's precision.
inline void expect_scan(const Scan& got, const Scan& want) {
  EXPECT_EQ(got.points, want.points);
  EXPECT_EQ(got.facets, want.facets);
  EXPECT_EQ(got.labels, want.labels);
  ASSERT_EQ(got.normals.size(), want.normals.size());
  for (size_t i = 0; i < got.normals.size(); ++i) {
    EXPECT_LT((got.normals[i] - want.normals[i]).norm(), 1e-6f) << "normal " << i;
  }
}

/// Fails where a reader does not refuse some bytes in one line that names the file, the remedy, and
/// holds `words`.
template <typename Reader>
void expect_refused(const Reader& reader, const std::string& bytes, const std::string& words) {
  const std::string path = "some/scan.file";
  const Error error = error_of([&] { reader(bytes, path); }, path);
  EXPECT_EQ(error.code(), ExitCode::kBadInput) << error.what();
  EXPECT_THAT(error.what(), testing::HasSubstr(words));
  EXPECT_THAT(error.what(), testing::HasSubstr("; ")) << "no remedy";
}

/// Every prefix of a file is refused or gives a scan; nothing worse.
template <typename Reader>
void expect_prefixes_are_safe(const Reader& reader, const std::string& bytes) {
  for (size_t size = 0; size < bytes.size(); ++size) {
    try {
      const ScanFile file = reader(std::string_view(bytes).substr(0, size), "scan");
      EXPECT_FALSE(file.scan.points.empty());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kBadInput);
    }
  }
}

}  // namespace gable
