#include <gable/engine/solver/plane_uncertainty.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gable {
namespace {

struct Fit {
  OrientedPlane plane;
  PointMoments moments;
};

// Least squares through points of a rectangle (half sizes 3 and 1) around (10, 20, 5) on a plane.
Fit fit(const Eigen::Vector3d& u, const Eigen::Vector3d& v, int count, double noise,
        Random* random) {
  Fit out;
  out.moments.reference = {10.0, 20.0, 5.0};
  for (int i = 0; i < count; ++i) {
    out.moments.add(
        out.moments.reference + u * random->uniform(-3.0, 3.0) + v * random->uniform(-1.0, 1.0) +
        Eigen::Vector3d(random->normal(noise), random->normal(noise), random->normal(noise)));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(out.moments.scatter());
  Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  if (normal.dot(u.cross(v)) < 0.0) normal = -normal;
  out.plane = {normal, normal.dot(out.moments.centroid())};
  return out;
}

TEST(PlaneUncertainty, IsWhatManyFitsToFreshNoiseScatterBy) {
  const Eigen::Vector3d u(0.6, 0.0, 0.8), v(0.0, 1.0, 0.0), truth = u.cross(v);
  const Eigen::Vector3d corner = Eigen::Vector3d(10.0, 20.0, 5.0) + 3.0 * u + v;
  for (const double noise : {0.05, 0.3}) {  // 0.3 is half the plane's width
    Random random(4);
    Eigen::Vector3d seen = Eigen::Vector3d::Zero(), said = Eigen::Vector3d::Zero();
    const int rounds = 4000;
    for (int i = 0; i < rounds; ++i) {
      const Fit f = fit(u, v, 60, noise, &random);
      const PlaneUncertainty uncertainty = plane_uncertainty(f.plane, f.moments);
      seen += Eigen::Vector3d(std::pow(f.plane.normal().dot(u), 2),
                              std::pow(f.plane.normal().dot(v), 2),
                              std::pow(f.plane.signed_distance(corner), 2)) /
              rounds;
      said += Eigen::Vector3d(u.dot(uncertainty.normal * u), v.dot(uncertainty.normal * v),
                              uncertainty.variance_at(corner)) /
              rounds;
      EXPECT_NEAR(uncertainty.noise, noise, 0.6 * noise);
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(said[k] / seen[k], 1.0, 0.12) << noise << " " << k;
    EXPECT_NEAR(truth.norm(), 1.0, 1e-12);
  }
}

TEST(PlaneUncertainty, ADirectionThatThePointsLeaveOpenIsOneRadian) {
  PointMoments line;
  for (int i = 0; i < 10; ++i) line.add({0.1 * i, i % 2 ? 0.01 : -0.01, i % 3 ? 0.01 : -0.01});
  const PlaneUncertainty uncertainty = plane_uncertainty({{0.0, 0.0, 1.0}, 0.0}, line);
  EXPECT_GT(uncertainty.angle_deviation(), 0.3);
  EXPECT_LE(uncertainty.angle_deviation(), 1.0 + 1e-12);
  EXPECT_LT(uncertainty.normal(0, 0), 0.01);
  EXPECT_TRUE(plane_uncertainty({}, PointMoments()).normal.allFinite());
}

TEST(PlaneUncertainty, ExactPointsLeaveNothingOpen) {
  Random random(1);
  const Fit f = fit({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 20, 0.0, &random);
  EXPECT_LT(plane_uncertainty(f.plane, f.moments).angle_deviation(), 1e-6);
}

}  // namespace
}  // namespace gable
