#include <gable/grammar/random.h>
#include <gable/residuals/point_moments.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace gable {
namespace {

using Eigen::Vector3d;

Vector3d random_point(Random* random) {
  return {random->uniform(-1, 1), random->uniform(-1, 1), random->uniform(-1, 1)};
}

TEST(TriangleMoments, AreThoseOfManySmallPieces) {
  Random random(3);
  const Vector3d a = random_point(&random), b = random_point(&random), c = random_point(&random);
  const PointMoments exact = triangle_moments(a, b, c, Vector3d(0.3, 0.2, 0.1));
  PointMoments sum;
  sum.reference = Vector3d(0.3, 0.2, 0.1);
  constexpr int kSteps = 200;
  const double piece = 0.5 * (b - a).cross(c - a).norm() / (kSteps * kSteps);
  const Vector3d u = (b - a) / kSteps, v = (c - a) / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; i + j < kSteps; ++j) {
      sum.add(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v, piece);
      if (i + j + 1 < kSteps) sum.add(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v, piece);
    }
  }
  EXPECT_NEAR(exact.weight, sum.weight, 1e-12);
  EXPECT_LT((exact.sum - sum.sum).norm(), 1e-9);
  EXPECT_LT((exact.squares - sum.squares).norm(), 1e-5);
}

}  // namespace
}  // namespace gable
