#include <gable/engine/scales/measure_shapes.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

TEST(MeasureShapes, OfACloudTheMeansOverThePoints) {
  Scan scan;
  scan.points = {{0, 0, 0.1}, {2, 0, -0.1}, {0, 2, 0.1}, {2, 2, -0.1}, {9, 9, 9}};
  const ScaleShapes shapes =
      measure_shapes(scan, {0, 0, 0, 0, -1}, {OrientedPlane({0, 0, -1}, 0.0)});
  ASSERT_EQ(shapes.shapes.size(), 1u);
  const PlanarShape& shape = shapes.shapes[0];
  EXPECT_EQ(shape.inliers, 4);
  EXPECT_NEAR((shape.centroid - Eigen::Vector3d(1, 1, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(shape.rms, 0.1, 1e-12);
  EXPECT_EQ(shape.plane.normal().z(), 1.0);  // up
  EXPECT_NEAR(shapes.rms, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(shapes.coverage, 0.8);
}

TEST(MeasureShapes, NormalsTurnToTheSideOfThePoints) {
  Scan scan;
  scan.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  scan.normals.assign(3, Eigen::Vector3f(0, 0, -1));
  const ScaleShapes shapes = measure_shapes(scan, {0, 0, 0}, {OrientedPlane({0, 0, 1}, 0.0)});
  EXPECT_EQ(shapes.shapes[0].plane.normal().z(), -1.0);
}

TEST(MeasureShapes, OfAMeshFacetsWeighByArea) {
  // A square of 4 square metres at height 1, facing down, a triangle of 0.5 at height 0 and a
  // facet without area.
  Scan scan;
  scan.points = {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  scan.facets.add(std::vector{0, 3, 2, 1});
  scan.facets.add(std::vector{4, 5, 6});
  scan.facets.add(std::vector{4, 4, 5});
  const OrientedPlane level({0, 0, 1}, 0.9);
  const ScaleShapes both = measure_shapes(scan, {0, 0, 0}, {level});
  EXPECT_EQ(both.shapes[0].inliers, 3);
  EXPECT_EQ(both.shapes[0].plane.normal().z(), -1.0);
  EXPECT_NEAR(both.shapes[0].rms, std::sqrt((4 * 0.01 + 0.5 * 0.81) / 4.5), 1e-12);
  EXPECT_NEAR(both.shapes[0].centroid.z(), 4 / 4.5, 1e-12);
  EXPECT_NEAR(both.coverage, 1.0, 1e-12);
  const ScaleShapes one = measure_shapes(scan, {0, -1, -1}, {level});
  EXPECT_NEAR(one.coverage, 4 / 4.5, 1e-12);
  EXPECT_NEAR(one.shapes[0].rms, 0.1, 1e-12);
}

TEST(MeasureShapes, NothingGivesNothing) {
  EXPECT_TRUE(measure_shapes(Scan(), {}, {}).shapes.empty());
  EXPECT_EQ(measure_shapes(Scan(), {}, {}).coverage, 0.0);
}

}  // namespace
}  // namespace gable
