#include <gable/engine/scales/shape_plane.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

using Eigen::Vector3d;

TEST(PlaneRms, OfTwoParallelSquaresIsHalfTheirDistance) {
  PointMoments both;
  for (double z : {0.0, 0.4}) {
    both += triangle_moments({0, 0, z}, {1, 0, z}, {1, 1, z}, Vector3d::Zero());
    both += triangle_moments({0, 0, z}, {1, 1, z}, {0, 1, z}, Vector3d::Zero());
  }
  EXPECT_NEAR(plane_rms(both), 0.2, 1e-9);
}

TEST(ShapePlane, OfAFlatRectangleIsItsPlaneWithTheWidthOfItsShorterSide) {
  PointMoments moments;
  for (int x = 0; x <= 100; ++x) {
    for (int y = 0; y <= 20; ++y) moments.add({0.1 * x, 3.0, 0.1 * y});
  }
  const ShapePlane plane = shape_plane(moments);
  EXPECT_NEAR(std::abs(plane.normal.y()), 1.0, 1e-9);
  EXPECT_LT((plane.centroid - Vector3d(5.0, 3.0, 1.0)).norm(), 1e-12);
  EXPECT_NEAR(plane.rms, 0.0, 1e-7);
  EXPECT_NEAR(plane.width, 0.1 * std::sqrt((21.0 * 21.0 - 1.0) / 12.0), 1e-9);
}

}  // namespace
}  // namespace gable
