#include <gable/engine/scales/cheapest_configuration.h>
#include <gable/engine/scales/refit_shapes.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// A gable of 12 x 8 m, ridge 3 m above the eaves, with a flat box 1 m high on one slope.
Scan gable_with_box(double noise) {
  Scan scan;
  Random random(5);
  for (double x = 0.25; x < 12.0; x += 0.5) {
    for (double y = 0.25; y < 8.0; y += 0.5) {
      double z = 5.0 + 3.0 * (1.0 - std::abs(y - 4.0) / 4.0);
      if (x > 4.0 && x < 7.0 && y > 1.0 && y < 3.0) z = 8.0;
      scan.points.emplace_back(x, y, z + random.normal(noise));
    }
  }
  return scan;
}

CollapsedScan collapsed(const Scan& scan) {
  FirstShapesOptions options;
  options.neighbours = 12;
  options.epsilon_deviations = 0.0;
  options.epsilon_percent = 1.5;
  options.min_inliers = 6;
  return collapse_scan(scan, options);
}

// The same sum for every configuration, each from its points.
int slow_cheapest(const Scan& scan, const CollapsedScan& scans, double deviation) {
  double least = std::numeric_limits<double>::infinity();
  int best = 0;
  for (int c = 0; c < scans.trajectory.num_configurations(); ++c) {
    const std::vector<int> shape_of = shapes_of_elements(scans, c);
    double sum = 3.0 * scans.trajectory.num_shapes(c) * std::log(scan.points.size());
    for (int shape = 0; shape < scans.trajectory.num_shapes(c); ++shape) {
      std::vector<Eigen::Vector3d> own;
      for (size_t i = 0; i < shape_of.size(); ++i) {
        if (shape_of[i] == shape) own.push_back(scan.points[i]);
      }
      const PointMoments moments = moments_of(own);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.scatter());
      for (const Eigen::Vector3d& p : own) {
        const double d = eigen.eigenvectors().col(0).dot(p - moments.centroid()) / deviation;
        sum += std::min(d * d, 9.0);
      }
    }
    if (sum <= least + 1e-9) {
      least = sum;
      best = c;
    }
  }
  return best;
}

TEST(CheapestConfiguration, IsThatOfTheLeastSumOverAllConfigurations) {
  for (const double noise : {0.02, 0.1, 0.3}) {
    const Scan scan = gable_with_box(noise);
    const CollapsedScan scans = collapsed(scan);
    for (const double deviation : {0.05, 0.1, 0.3, 1.0, 3.0}) {
      EXPECT_EQ(cheapest_configuration(scan.points, scans, deviation),
                slow_cheapest(scan, scans, deviation))
          << noise << " " << deviation;
    }
  }
}

TEST(CheapestConfiguration, IsCoarserForWiderDeviations) {
  const Scan scan = gable_with_box(0.05);
  const CollapsedScan scans = collapsed(scan);
  const int fine = cheapest_configuration(scan.points, scans, 0.05);
  const int coarse = cheapest_configuration(scan.points, scans, 3.0);
  EXPECT_GE(scans.trajectory.num_shapes(fine), 3);
  EXPECT_LT(scans.trajectory.num_shapes(coarse), 3);
}

TEST(CheapestConfiguration, IsTheFirstOfAScanWithoutShapes) {
  Scan scan;
  scan.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  EXPECT_EQ(cheapest_configuration(scan.points, collapsed(scan), 0.1), 0);
}

}  // namespace
}  // namespace gable
