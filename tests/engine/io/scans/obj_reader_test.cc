#include <gable/engine/io/scans/obj_reader.h>

#include "engine/io/scans/expect_scan.h"
#include "engine/io/scans/sample_files.h"

namespace gable {
namespace {

constexpr char kSquare[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, GivesTheMeshThatWasWritten) {
  Scan want = sample_mesh();
  want.labels.clear();
  expect_scan(read_obj(obj_file(want), "scan").scan, want);
}

TEST(Obj, GivesTheCloudThatWasWritten) {
  Scan want = sample_cloud();
  want.labels.clear();
  expect_scan(read_obj(obj_file(want), "scan").scan, want);
}

TEST(Obj, ReadsEveryFormOfCorner) {
  Facets want;
  want.add(std::vector{0, 1, 2, 3});
  const std::string normals = "vn 0 0 1\nvt 0 0\n";
  for (const char* facet :
       {"f 1 2 3 4\n", "f 1/1 2/1 3/1 4/1\n", "f 1//1 2//1 3//1 4//1\n",
        "f 1/1/1 2/1/1 3/1/1 4/1/1", "f -4 -3 -2 -1\n", "f -4//-1 -3//-1 -2//-1 -1//-1\n",
        "f 1 2 \\\n 3 4\n", "f 1/ 2/ 3/ 4/"}) {
    const Scan scan = read_obj(kSquare + normals + facet, "scan").scan;
    EXPECT_EQ(scan.facets, want) << facet;
    EXPECT_EQ(scan.normals.size(), 4u) << facet;
  }
}

TEST(Obj, LetsFacetsComeBeforeTheirPoints) {
  EXPECT_EQ(read_obj(std::string("f 1 2 3\n") + kSquare, "scan").scan.facets.size(), 1u);
}

TEST(Obj, GivesAPointTheMeanNormalOfItsCorners) {
  const Scan scan =
      read_obj(std::string(kSquare) + "vn 0 0 3\nvn 3 0 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n",
               "scan")
          .scan;
  EXPECT_LT((scan.normals[0] - Eigen::Vector3f(1, 0, 1).normalized()).norm(), 1e-6f);
  EXPECT_LT((scan.normals[1] - Eigen::Vector3f(0, 0, 1)).norm(), 1e-6f);
  EXPECT_LT((scan.normals[3] - Eigen::Vector3f(1, 0, 0)).norm(), 1e-6f);
}

TEST(Obj, IgnoresLinesPointsAndColours) {
  const Scan scan = read_obj("v 1 2 3 0.5 0.5 0.5\nl 1 1\np 1\ng a b\n", "scan").scan;
  EXPECT_EQ(scan.points, (std::vector<Eigen::Vector3d>{{1, 2, 3}}));
  EXPECT_FALSE(scan.is_mesh());
}

TEST(Obj, RefusesWhatIsNone) {
  const std::string square = kSquare;
  expect_refused(read_obj, "", "holds no points");
  expect_refused(read_obj, "# nothing\n", "holds no points");
  expect_refused(read_obj, "v 1 2\n", "line 1: a coordinate is missing");
  expect_refused(read_obj, "v 1 2 x\n", "line 1: \"x\" is no number");
  expect_refused(read_obj, square + "f 1 2 5\n", "facet 1 uses a point");
  expect_refused(read_obj, square + "f 1 2 0\n", "line 5: a facet uses a point");
  expect_refused(read_obj, square + "f -1 -2 -5\n", "line 5: a facet uses a point");
  expect_refused(read_obj, square + "f 1 2 c\n", "line 5: a corner of a facet is no index");
  expect_refused(read_obj, square + "f 1 2 3a\n", "line 5: a corner of a facet is no index");
  expect_refused(read_obj, square + "f 1 2 99999999999999999999\n", "is no index");
  expect_refused(read_obj, square + "f 1 2 9999999999\n", "uses a point");
  expect_refused(read_obj, square + "vn 0 0 1\nf 1//1 2//1 3//2\n", "uses a normal");
}

TEST(Obj, IsSafeWhereverTheFileEnds) {
  expect_prefixes_are_safe(read_obj, obj_file(sample_mesh()));
}

}  // namespace
}  // namespace gable
