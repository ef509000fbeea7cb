#include <gable/grammar/random.h>
#include <gable/residuals/moments_to_plane.h>
#include <gable/residuals/point_to_plane.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace gable {
namespace {

struct Plain {
  double cost = 0.0;
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
};

Plain evaluate(const ceres::CostFunction& cost, const Eigen::Vector4d& plane) {
  const int m = cost.num_residuals();
  Eigen::VectorXd residuals(m);
  Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor> jacobian(m, 4);
  const double* parameters[] = {plane.data()};
  double* jacobians[] = {jacobian.data()};
  EXPECT_TRUE(cost.Evaluate(parameters, residuals.data(), jacobians));
  return {residuals.squaredNorm(), jacobian.transpose() * residuals,
          jacobian.transpose() * jacobian};
}

TEST(MomentsToPlane, EqualsPointToPlaneOverAllPoints) {
  Random random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d center(random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), 9.0);
    Eigen::Vector3d normal(random.normal(1.0), random.normal(1.0), random.normal(1.0));
    normal.normalize();
    const OrientedPlane plane(normal, random.uniform(-9.0, 9.0));
    PointMoments moments;
    moments.reference = center;
    Plain plain;
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d p =
          center + Eigen::Vector3d(random.normal(3.0), random.normal(3.0), random.normal(0.1));
      const double weight = random.uniform(0.1, 2.0);
      moments.add(p, weight);
      const std::unique_ptr<ceres::CostFunction> cost(PointToPlane::create(p, std::sqrt(weight)));
      const Plain one = evaluate(*cost, plane.values);
      plain.cost += one.cost;
      plain.gradient += one.gradient;
      plain.hessian += one.hessian;
    }
    const Plain fast = evaluate(MomentsToPlane(moments), plane.values);
    EXPECT_NEAR(fast.cost, plain.cost, 1e-10 * plain.cost);
    EXPECT_LE((fast.gradient - plain.gradient).norm(), 1e-10 * plain.gradient.norm());
    EXPECT_LE((fast.hessian - plain.hessian).norm(), 1e-10 * plain.hessian.norm());
  }
}

TEST(MomentsToPlane, UnitedMomentsAreThoseOfTheUnion) {
  Random random(12);
  PointMoments a, b, both;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d p(random.normal(1.0), random.normal(1.0), random.normal(1.0));
    (i % 2 ? a : b).add(p);
    both.add(p);
  }
  a += b;
  EXPECT_EQ(a.weight, both.weight);
  EXPECT_LE((a.centroid() - both.centroid()).norm(), 1e-14);
  EXPECT_LE((a.scatter() - both.scatter()).norm(), 1e-13);
}

TEST(MomentsToPlane, CoplanarPointsCostNothingOnTheirPlane) {
  std::vector<Eigen::Vector3d> points = {{1, 2, 3}, {4, 2, 3}, {1, 7, 3}, {5, 5, 3}};
  const Plain at = evaluate(MomentsToPlane(moments_of(points)), {0.0, 0.0, 1.0, 3.0});
  EXPECT_NEAR(at.cost, 0.0, 1e-24);
}

}  // namespace
}  // namespace gable
