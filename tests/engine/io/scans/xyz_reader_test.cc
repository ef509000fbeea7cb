#include <gable/engine/io/scans/xyz_reader.h>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

ScanFile read_unknown(std::string_view bytes, const std::string& path) {
  return read_xyz(bytes, path, XyzColumns::kUnknown);
}
ScanFile read_normals(std::string_view bytes, const std::string& path) {
  return read_xyz(bytes, path, XyzColumns::kNormals);
}

Scan without_labels(Scan scan) {
  scan.labels.clear();
  return scan;
}

TEST(Xyz, GivesThePointsThatWereWritten) {
  Scan want = without_labels(sample_cloud());
  expect_scan(read_normals(xyz_file(want, true), "scan").scan, want);
  expect_scan(read_unknown(xyz_file(want, true), "scan").scan, want);
  const std::string text = xyz_file(want, false);
  want.normals.clear();
  expect_scan(read_unknown(text, "scan").scan, want);
}

TEST(Xyz, TakesFurtherColumnsForNormalsOnlyWhereAllAreUnit) {
  EXPECT_EQ(read_unknown("1 2 3 0 0 1 99\n1 2 4 0 0 0.995 99\n", "scan").scan.normals.size(), 2u);
  EXPECT_TRUE(read_unknown("1 2 3 0 0 1\n1 2 4 0 0 0.98\n", "scan").scan.normals.empty());
  EXPECT_TRUE(
      read_unknown("1 2 3 149 120 86 159 51423.0\n4 5 6 0 0 1 1 1\n", "scan").scan.normals.empty());
}

TEST(Xyz, ReadsAnySeparatorHeadingsAndComments) {
  const std::vector<Eigen::Vector3d> want = {{1, 2, 3}, {4, 5, -6}};
  for (const char* text : {
           "1 2 3\n4 5 -6",
           "x,y,z\n1,2,3\n4,5,-6\n",
           "// points\r\n1;2;3\r\n\r\n4;5;-6\r\n",
           "# points\n  1\t2\t3 # the first\n+4e0 .5e1 -6.\n\n\n",
       }) {
    EXPECT_EQ(read_unknown(text, "scan").scan.points, want) << text;
  }
}

TEST(Xyz, SkipsRowsThatAreNotFinite) {
  const ScanFile file = read_normals(
      "nan 0 0 0 0 1\n1 2 3 1 0 0\n1e400 0 0 0 0 1\n-inf 0 0 0 0 1\n"
      "1e-400 4 5 0 nan 0\n2e12 0 0 1 0 0\n",
      "scan");
  EXPECT_EQ(file.skipped_points, 4u);
  EXPECT_EQ(file.scan.points, (std::vector<Eigen::Vector3d>{{1, 2, 3}, {0, 4, 5}}));
  EXPECT_EQ(file.scan.normals, (std::vector<Eigen::Vector3f>{{1, 0, 0}, {0, 0, 0}}));
}

TEST(Xyz, RefusesWhatIsNone) {
  expect_refused(read_unknown, "", "holds no points");
  expect_refused(read_unknown, "# nothing\n\n", "holds no points");
  expect_refused(read_unknown, "x y z\n", "holds no points");
  expect_refused(read_unknown, "1 2\n", "line 1: has 2 columns");
  expect_refused(read_normals, "1 2 3\n", "at least 6");
  expect_refused(read_unknown, "1 2 3\n1 2\n", "line 2: has 2 columns, the first row has 3");
  expect_refused(read_unknown, "1 2 3\n1 2 3 4\n", "line 2: has 4 columns");
  expect_refused(read_unknown, "1 2 3\n1 2 3x\n", "line 2: \"3x\" is no number");
  expect_refused(read_unknown, "1 2 3\n1 --2 3\n", "is no number");
  expect_refused(read_unknown, "nan nan nan\n", "no point with finite coordinates");
}

TEST(Xyz, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_normals, xyz_file(sample_cloud(), true));
}

TEST(Pwn, GivesThePointsThatWereWritten) {
  const Scan want = without_labels(sample_cloud());
  expect_scan(read_pwn(pwn_file(want), "scan").scan, want);
  expect_scan(read_pwn(xyz_file(want, true), "scan").scan, want);
}

TEST(Pwn, RefusesWhatIsNone) {
  expect_refused(read_pwn, "", "holds no points");
  expect_refused(read_pwn, "0\n", "holds no points");
  expect_refused(read_pwn, "2.5\n", "no whole number");
  expect_refused(read_pwn, "-3\n0 0 0\n", "announces -3 points");
  const std::string text = pwn_file(sample_cloud());
  expect_refused(read_pwn, "1000000000" + text.substr(1), "announces 1000000000 points");
  expect_refused(read_pwn, "6" + text.substr(1), "file ends where a normal is due");
  expect_refused(read_pwn, "4" + text.substr(1), "more numbers than the 4 points");
}

TEST(Pwn, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_pwn, pwn_file(sample_cloud()));
}

}  // namespace
}  // namespace gable
