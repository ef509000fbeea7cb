#include <gable/engine/io/scans/off_reader.h>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

TEST(Off, GivesTheMeshThatWasWritten) {
  Scan want = sample_mesh();
  want.labels.clear();
  expect_scan(read_off(off_file(want), "scan").scan, want);
}

TEST(Off, ReadsCountsWhereverTheyStand) {
  for (const char* head : {"OFF\n3 1 3\n", "OFF 3 1 3\n", "OFF3 1 3\n", "COFF # c\n\n3 1 0 # c\n",
                           "STOFF\r\n3 1\r\n", "OFF\n3\n1\n3\n"}) {
    const ScanFile file =
        read_off(std::string(head) + "0 0 0\n1 0 0 255 255\n0 1 0\n# facets\n3 0 1 2\n", "scan");
    EXPECT_EQ(file.scan.points.size(), 3u) << head;
    EXPECT_EQ(file.scan.facets.size(), 1u) << head;
  }
}

TEST(Off, MakesACloudOfAFileWithoutFacets) {
  const Scan scan = read_off("NOFF\n1 0 0\n1 2 3 0 0 2\n", "scan").scan;
  EXPECT_FALSE(scan.is_mesh());
  EXPECT_EQ(scan.normals[0], Eigen::Vector3f(0, 0, 1));
}

TEST(Off, RefusesWhatIsNone) {
  expect_refused(read_off, "", "does not start with OFF");
  expect_refused(read_off, "ply\n", "does not start with OFF");
  expect_refused(read_off, "OFF BINARY\n", "binary");
  expect_refused(read_off, "4OFF\n", "three dimensions");
  expect_refused(read_off, "OFF\n", "number of points is due");
  expect_refused(read_off, "OFF\n0 0 0\n", "holds no points");
  expect_refused(read_off, "OFF\n-1 0 0\n", "more than the file can hold");
  expect_refused(read_off, "OFF\n2000000000 2000000000 0\n0 0 0\n", "more than the file can hold");
  expect_refused(read_off, "OFF\n2 0 0\n0.0 0.0 0.0\n0 1\n", "file ends where a coordinate is due");
  expect_refused(read_off, "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "line 4: a facet uses a point");
  expect_refused(read_off, "OFF\n1 1 0\n0 0 0\n3 0 0 -1\n", "line 4: a facet uses a point");
  expect_refused(read_off, "OFF\n1 1 0\n0 0 0\n90000000 0\n", "more corners than the file");
  expect_refused(read_off, "OFF\n1 1 0\n0 0 zero\n", "line 3: \"zero\" is no number");
}

TEST(Off, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_off, off_file(sample_mesh()));
}

}  // namespace
}  // namespace gable
