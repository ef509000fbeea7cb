#include <gable/engine/io/scans/ply_reader.h>

#include <limits>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

class PlyFormats : public testing::TestWithParam<const char*> {};

TEST_P(PlyFormats, GiveTheCloudThatWasWritten) {
  expect_scan(read_ply(ply_file(sample_cloud(), GetParam()), "scan").scan, sample_cloud());
}

TEST_P(PlyFormats, GiveTheMeshThatWasWritten) {
  expect_scan(read_ply(ply_file(sample_mesh(), GetParam()), "scan").scan, sample_mesh());
}

TEST_P(PlyFormats, AreSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_ply, ply_file(sample_mesh(), GetParam()));
}

TEST_P(PlyFormats, RefuseACornerThatIsNoPoint) {
  Scan scan = sample_mesh();
  scan.facets.add(std::vector{0, 1, 5});
  scan.labels["plane"].push_back(0);
  expect_refused(read_ply, ply_file(scan, GetParam()), "facet 3 uses a point");
}

TEST_P(PlyFormats, RefuseACountBeyondTheFile) {
  for (const char* count : {"6", "1000000", "2000000000", "9000000000000"}) {
    const std::string text =
        with(ply_file(sample_cloud(), GetParam()), "vertex 5", std::string("vertex ") + count);
    EXPECT_THROW(read_ply(text, "scan"), Error) << count;
  }
  expect_refused(read_ply, with(ply_file(sample_mesh(), GetParam()), "face 2", "face 2000000000"),
                 "announces 2000000000 times \"face\"");
}

TEST_P(PlyFormats, SkipPointsThatAreNotFiniteAndTheirFacets) {
  Scan scan = sample_mesh();
  scan.points[1].x() = std::numeric_limits<double>::quiet_NaN();
  const ScanFile file = read_ply(ply_file(scan, GetParam()), "scan");
  EXPECT_EQ(file.skipped_points, 1u);
  EXPECT_EQ(file.skipped_facets, 1u);
  Scan want = sample_mesh();
  want.points.erase(want.points.begin() + 1);
  want.normals.erase(want.normals.begin() + 1);
  want.facets = {};
  want.facets.add(std::vector{0, 1, 2, 3});
  want.labels["plane"] = {-1};
  expect_scan(file.scan, want);
}

INSTANTIATE_TEST_SUITE_P(All, PlyFormats,
                         testing::Values("ascii", "binary_little_endian", "binary_big_endian"));

std::string one_point(const std::string& properties, const std::string& values) {
  return "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\n" + properties + "end_header\r\n" + values;
}

constexpr char kXyz[] = "property float x\r\nproperty float y\r\nproperty float z\r\n";

TEST(Ply, ReadsWindowsLineEndsAndLabelsOfAnyIntegerType) {
  const std::string text = one_point(
      std::string(kXyz) + "property uint region\r\nproperty int8 id\r\nproperty float c\r\n",
      "1 +2 3e1 4294967295 7 8\r\n");
  const Scan scan = read_ply(text, "scan").scan;
  EXPECT_EQ(scan.points[0], Eigen::Vector3d(1, 2, 30));
  const std::map<std::string, std::vector<int>> want = {{"region", {-1}}, {"id", {7}}};
  EXPECT_EQ(scan.labels, want);
}

TEST(Ply, KeepsNormalsOnlyWhereAllThreeAreThere) {
  const std::string text = one_point(std::string(kXyz) + "property float nx\r\n", "1 2 3 1\r\n");
  EXPECT_TRUE(read_ply(text, "scan").scan.normals.empty());
}

TEST(Ply, DropsFacetsOfFewerThanThreeCorners) {
  std::string text = ply_file(sample_mesh(), "ascii");
  text = with(with(text, "face 2", "face 3"), "3 0 1 2 3 ", "2 0 1 9\n3 0 1 2 3 ");
  const ScanFile file = read_ply(text, "scan");
  EXPECT_EQ(file.skipped_facets, 1u);
  expect_scan(file.scan, sample_mesh());
}

TEST(Ply, RefusesWhatIsNone) {
  expect_refused(read_ply, "", "is no PLY file");
  expect_refused(read_ply, "solid cube", "is no PLY file");
  expect_refused(read_ply, "ply\nformat ascii 1.0\n", "ends within its header");
  expect_refused(read_ply, "ply\nelement vertex 1\nend_header\n", "does not tell the format");
  expect_refused(read_ply, "ply\nformat text 1.0\nend_header\n", "format is none of");
  expect_refused(read_ply, "ply\nformat ascii 1.0\nend_header\n", "no element vertex");
  expect_refused(read_ply, "ply\nformat ascii 1.0\nelement vertex -1\n", "is negative");
  expect_refused(read_ply, one_point("property float x\r\nproperty float y\r\n", "1 2\r\n"),
                 "no property z");
  expect_refused(read_ply, one_point("property quad x\r\n", "1\r\n"), "no known type");
  expect_refused(read_ply, one_point(kXyz, "1 two 3\r\n"), "line 8: \"two\" is no number");
  expect_refused(read_ply, one_point(kXyz, "nan nan nan\r\n"), "no point with finite");
  expect_refused(read_ply, with(one_point(kXyz, ""), "vertex 1", "vertex 0"), "holds no points");
}

TEST(Ply, RefusesAListBeyondTheFile) {
  expect_refused(read_ply, with(ply_file(sample_mesh(), "ascii"), "3 0 1 2", "300000000 0 1 2"),
                 "list has more entries");
}

}  // namespace
}  // namespace gable
