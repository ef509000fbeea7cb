#include <gable/engine/closing/surface_distance.h>
#include <gable/grammar/random.h>
#include <gable/grammar/solid/extrusion.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

TEST(SurfaceDistance, OfABoxIsWhatItsBoundsSay) {
  const Eigen::Vector3d low(0, 0, -1), high(4, 3, 2);
  const SurfaceDistance distance({extrude({{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}}, -1.0, 2.0)});
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p(random.uniform(-3, 7), random.uniform(-3, 6), random.uniform(-4, 5));
    const Eigen::Vector3d beyond = (low - p).cwiseMax(p - high);
    const double expected =
        beyond.maxCoeff() > 0.0 ? beyond.cwiseMax(0.0).norm() : -beyond.maxCoeff();
    EXPECT_NEAR(distance(p), expected, 1e-9);
  }
}

TEST(SurfaceDistance, OfNothingIsInfinite) {
  EXPECT_TRUE(std::isinf(SurfaceDistance({})(Eigen::Vector3d::Zero())));
}

}  // namespace
}  // namespace gable
