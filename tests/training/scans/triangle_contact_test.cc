#include <gable/grammar/random.h>
#include <gable/training/scans/triangle_contact.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gable {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;
using testing::Pair;

TriangleCorners random_triangle(Random* random) {
  TriangleCorners out;
  const Vector3d middle(random->uniform(-1, 1), random->uniform(-1, 1), random->uniform(-1, 1));
  for (Vector3d& p : out) {
    p = middle + Vector3d(random->uniform(-1, 1), random->uniform(-1, 1), random->uniform(-1, 1));
  }
  return out;
}

std::vector<Vector3d> lattice(const TriangleCorners& t, int steps) {
  std::vector<Vector3d> out;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      out.push_back(t[0] + (t[1] - t[0]) * i / steps + (t[2] - t[0]) * j / steps);
    }
  }
  return out;
}

TEST(TriangleDistance, IsThatOfTheNearestOfManyPoints) {
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    const TriangleCorners a = random_triangle(&random), b = random_triangle(&random);
    double nearest = 1e9;
    for (const Vector3d& p : lattice(a, 40)) {
      for (const Vector3d& q : lattice(b, 40)) nearest = std::min(nearest, (p - q).norm());
    }
    // The lattices' points lie within 0.09 of any point of triangles with sides under 3.5.
    EXPECT_LE(distance(a, b), nearest + 1e-12);
    EXPECT_GE(distance(a, b), nearest - 0.18);
  }
}

TEST(TriangleDistance, IsExactForCornersEdgesAndFaces) {
  const TriangleCorners flat = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
  EXPECT_NEAR(distance(flat, {{{0.5, 0.5, 0.3}, {0.5, 0.5, 2}, {1, 0.5, 2}}}), 0.3, 1e-12);
  EXPECT_NEAR(distance(flat, {{{1, -0.5, -1}, {1, -0.5, 1}, {1, -3, 0}}}), 0.5, 1e-12);
  EXPECT_NEAR(distance(flat, {{{0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.6, 0.5, 1}}}), 0.0, 1e-12);
  EXPECT_NEAR(distance(flat, {{{-3, -4, 0}, {-5, -4, 0}, {-3, -6, 1}}}), 5.0, 1e-12);
}

TEST(TouchingGroups, AreAllPairsWithinTheTolerance) {
  Random random(9);
  std::vector<TriangleCorners> triangles;
  std::vector<int> groups;
  for (int i = 0; i < 40; ++i) {
    triangles.push_back(random_triangle(&random));
    for (Vector3d& p : triangles.back()) p *= 0.4;
    groups.push_back(i / 2);
  }
  std::vector<std::pair<int, int>> expected;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      if (groups[i] < groups[j] && distance(triangles[i], triangles[j]) <= 0.05) {
        expected.push_back({groups[i], groups[j]});
      }
    }
  }
  std::sort(expected.begin(), expected.end());
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  ASSERT_GT(expected.size(), 10u);
  EXPECT_EQ(touching_groups(triangles, groups, 0.05), expected);
}

}  // namespace
}  // namespace gable
