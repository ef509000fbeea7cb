#include <gable/engine/evaluate/shape_evaluation.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

namespace gable {
namespace {

/// The least root mean square distance of weighted points to any plane, by brute force: a grid of
/// normals on a cube, then ever finer ones around the best.
double least_rms(const std::vector<Eigen::Vector3d>& points, const std::vector<double>& weights) {
  double sum = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < points.size(); ++i) {
    sum += weights[i];
    centroid += weights[i] * points[i];
  }
  centroid /= sum;
  const auto rms = [&](const Eigen::Vector3d& normal) {
    double squares = 0.0;
    for (size_t i = 0; i < points.size(); ++i) {
      squares += weights[i] * std::pow(normal.dot(points[i] - centroid), 2);
    }
    return std::sqrt(squares / sum);
  };
  double best = 1e300;
  Eigen::Vector3d normal;
  const auto look_at = [&](const Eigen::Vector3d& direction) {
    if (const double r = rms(direction.normalized()); r < best) {
      best = r;
      normal = direction.normalized();
    }
  };
  for (double x = -1.0; x <= 1.0; x += 0.1) {
    for (double y = -1.0; y <= 1.0; y += 0.1) {
      for (const Eigen::Vector3d& face :
           {Eigen::Vector3d(x, y, 1), Eigen::Vector3d(x, 1, y), Eigen::Vector3d(1, x, y)}) {
        look_at(face);
      }
    }
  }
  for (double step = 0.1; step > 1e-9; step *= 0.7) {
    const Eigen::Vector3d from = normal, u = from.unitOrthogonal(), v = from.cross(u);
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) look_at(from + step * (i * u + j * v));
    }
  }
  return best;
}

/// Flat, tilted blobs of 40 points each, far from the origin.
Scan blobs(int count) {
  Scan scan;
  Random random(4);
  for (int b = 0; b < count; ++b) {
    const Eigen::Vector3d place(84000.0 + 10.0 * b, 447000.0, 5.0 * b);
    for (int i = 0; i < 40; ++i) {
      const double u = random.uniform(-2, 2), v = random.uniform(-1, 1);
      scan.points.push_back(place + Eigen::Vector3d(u, v, 0.3 * u - 0.1 * b * v) +
                            Eigen::Vector3d(0, 0, random.normal(0.02 * (b + 1))));
    }
  }
  return scan;
}

TEST(EvaluateShapes, RmsOfACloudIsThatOfAnExhaustiveSearchForPlanes) {
  const Scan scan = blobs(3);
  std::vector<int> shape_of(120, -1);
  for (int i = 0; i < 110; ++i) {
    if (i % 7 != 0) shape_of[i] = 5 * (i / 40);  // numbers with gaps
  }
  double squares = 0.0, worst = 0.0, covered = 0.0;
  for (const int shape : {0, 5, 10}) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 120; ++i) {
      if (shape_of[i] == shape) points.push_back(scan.points[i]);
    }
    const double rms = least_rms(points, std::vector<double>(points.size(), 1.0));
    squares += points.size() * rms * rms;
    worst = std::max(worst, rms);
    covered += points.size();
  }
  const ShapeEvaluation got = evaluate_shapes(scan, shape_of);
  EXPECT_EQ(got.planes, 3);
  EXPECT_DOUBLE_EQ(got.coverage, covered / 120.0);
  EXPECT_NEAR(got.rms, std::sqrt(squares / covered), 1e-9);
  EXPECT_NEAR(got.worst_rms, worst, 1e-9);
}

TEST(EvaluateShapes, FacetsCountByTheirCornersAndArea) {
  Scan scan;
  scan.points = {{0, 0, 0}, {4, 0, 0.1}, {4, 3, -0.1}, {0, 3, 0.2}, {8, 0, 0.3}, {9, 9, 9}};
  scan.facets.add(std::vector<int>{0, 1, 2});  // about 6 square metres
  scan.facets.add(std::vector<int>{0, 2, 3});  // 6
  scan.facets.add(std::vector<int>{1, 4, 2});  // 6
  scan.facets.add(std::vector<int>{2, 4, 5});  // no shape
  scan.facets.add(std::vector<int>{0, 0, 1});  // no area
  const std::vector<int> shape_of = {1, 1, 1, -1, 1};
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
  double covered = 0.0;
  const auto area = [&](int a, int b, int c) {
    return 0.5 * (scan.points[b] - scan.points[a]).cross(scan.points[c] - scan.points[a]).norm();
  };
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}) {
    covered += area(a, b, c);
    for (const int corner : {a, b, c}) {
      points.push_back(scan.points[corner]);
      weights.push_back(area(a, b, c) / 3.0);
    }
  }
  const ShapeEvaluation got = evaluate_shapes(scan, shape_of);
  EXPECT_EQ(got.planes, 1);
  EXPECT_NEAR(got.coverage, covered / (covered + area(2, 4, 5)), 1e-12);
  EXPECT_NEAR(got.rms, least_rms(points, weights), 1e-9);
  EXPECT_DOUBLE_EQ(got.worst_rms, got.rms);
}

TEST(EvaluateShapes, NothingHasNothing) {
  const ShapeEvaluation got = evaluate_shapes(blobs(1), std::vector<int>(40, -1));
  EXPECT_EQ(got.planes, 0);
  EXPECT_EQ(got.coverage, 0.0);
  EXPECT_EQ(got.rms, 0.0);
}

TEST(AgreementIndex, LeavesOutElementsOfUnknownPlane) {
  const std::vector<int> truth = {0, 0, 1, 1, -1, -1};
  EXPECT_DOUBLE_EQ(agreement_index({7, 7, 3, 3, 3, -1}, truth), 1.0);
  // Elements without a shape are one class: that of plane 1 here.
  EXPECT_DOUBLE_EQ(agreement_index({7, 7, -1, -1, 7, 7}, truth), 1.0);
  // Hubert and Arabie by hand: {0,0,1,1} and {0,0,1,2} agree by 4/7.
  EXPECT_NEAR(agreement_index({0, 0, 1, 2, 0, 0}, truth), 4.0 / 7.0, 1e-12);
}

}  // namespace
}  // namespace gable
