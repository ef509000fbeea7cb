#include <gable/engine/io/scans/lzf.h>
#include <gable/engine/io/scans/pcd_reader.h>

#include <limits>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

class PcdData : public testing::TestWithParam<const char*> {};

TEST_P(PcdData, GivesTheCloudThatWasWritten) {
  expect_scan(read_pcd(pcd_file(sample_cloud(), GetParam()), "scan").scan, sample_cloud());
}

TEST_P(PcdData, SkipsPointsWithoutMeasurement) {
  Scan scan = sample_cloud();
  scan.points[2].setConstant(std::numeric_limits<double>::quiet_NaN());
  const ScanFile file = read_pcd(pcd_file(scan, GetParam()), "scan");
  EXPECT_EQ(file.skipped_points, 1u);
  Scan want = sample_cloud();
  want.points.erase(want.points.begin() + 2);
  want.normals.erase(want.normals.begin() + 2);
  want.labels["plane"] = {0, 1, 2, 7};
  expect_scan(file.scan, want);
}

TEST_P(PcdData, RefusesACountBeyondTheFile) {
  for (const char* count : {"POINTS 6\n", "POINTS 1000000\n", "POINTS 2000000000\n"}) {
    EXPECT_THROW(read_pcd(with(pcd_file(sample_cloud(), GetParam()), "POINTS 5\n", count), "scan"),
                 Error);
  }
}

TEST_P(PcdData, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_pcd, pcd_file(sample_cloud(), GetParam()));
}

INSTANTIATE_TEST_SUITE_P(All, PcdData, testing::Values("ascii", "binary", "binary_compressed"));

TEST(Pcd, TakesWidthTimesHeightWherePointsIsMissing) {
  const std::string text = with(with(pcd_file(sample_cloud(), "ascii"), "POINTS 5\n", ""),
                                "COUNT 1 1 1 3", "COUNT 1 1 1 3");
  expect_scan(read_pcd(text, "scan").scan, sample_cloud());
}

TEST(Pcd, RefusesWhatIsNone) {
  const std::string file = pcd_file(sample_cloud(), "ascii");
  expect_refused(read_pcd, "", "no DATA");
  expect_refused(read_pcd, "ply\n", "line 1: is no line of a PCD header");
  expect_refused(read_pcd, with(file, "DATA ascii", "DATA zip"), "DATA is none of");
  expect_refused(read_pcd, with(file, "FIELDS x", "FIELDS"), "different lengths");
  expect_refused(read_pcd, with(file, "FIELDS x", "FIELDS w"), "no field x");
  expect_refused(read_pcd, with(file, "SIZE 8", "SIZE 3"), "TYPE and SIZE");
  expect_refused(read_pcd, with(file, "COUNT 1", "COUNT -1"), "COUNT is out of range");
  expect_refused(read_pcd, with(file, "POINTS 5", "POINTS -5"), "POINTS is out of range");
  expect_refused(read_pcd, with(file, "POINTS 5", "POINTS 0"), "holds no points");
  expect_refused(read_pcd, with(file, "-3.25", "three"), "is no number");
  std::string packed = pcd_file(sample_cloud(), "binary_compressed");
  packed[packed.find("binary_compressed\n") + 18 + 8] = '\x7f';  // a copy before all data
  expect_refused(read_pcd, packed, "compressed data is damaged");
}

TEST(Lzf, CopiesWhatOverlapsItself) {
  std::string plain;
  // "ab", then 2 + 7 + 3 = 12 bytes from 2 back.
  ASSERT_TRUE(decompress_lzf(std::string_view("\x01"
                                              "ab\xe0\x03\x01",
                                              6),
                             14, &plain));
  EXPECT_EQ(plain, "ababababababab");
}

TEST(Lzf, RefusesDamagedInput) {
  std::string plain;
  EXPECT_FALSE(decompress_lzf(std::string_view("\x05"
                                               "ab",
                                               3),
                              6, &plain));  // literals missing
  EXPECT_FALSE(decompress_lzf(std::string_view("\x00"
                                               "a\x20",
                                               3),
                              4, &plain));  // distance missing
  EXPECT_FALSE(decompress_lzf(std::string_view("\x00"
                                               "a\xe0",
                                               3),
                              10, &plain));  // length missing
  EXPECT_FALSE(decompress_lzf(std::string_view("\x00"
                                               "a\x20\x01",
                                               4),
                              4, &plain));  // too far back
  EXPECT_FALSE(decompress_lzf(std::string_view("\x00"
                                               "a\x20\x00",
                                               4),
                              3, &plain));  // too long
  EXPECT_FALSE(decompress_lzf(std::string_view("\x00"
                                               "a\x20\x00",
                                               4),
                              5, &plain));  // too short
  EXPECT_FALSE(decompress_lzf("", size_t{1} << 40, &plain));
  EXPECT_TRUE(decompress_lzf(std::string_view("\x00"
                                              "a\x20\x00",
                                              4),
                             4, &plain));
}

}  // namespace
}  // namespace gable
