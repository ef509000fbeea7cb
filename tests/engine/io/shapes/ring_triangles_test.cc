#include <gable/engine/io/shapes/ring_triangles.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace gable {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

double area_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

double area_of(const Ring& ring) {
  double area = 0.0;
  for (size_t i = 1; i + 1 < ring.size(); ++i) area += area_of(ring[0], ring[i], ring[i + 1]);
  return area;
}

/// A ring about a centre with radii in [low, high]: simple, anticlockwise, as ragged as can be.
Ring star(const Eigen::Vector2d& centre, int corners, double low, double high, Random* random) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    ring.push_back(centre +
                   random->uniform(low, high) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// No triangle is turned over and their areas sum up to the polygon's: together a proof that they
/// cover it once, given that all corners are the polygon's and none lies outside.
void expect_covered(const std::vector<Ring>& rings) {
  Ring points;
  double area = 0.0;
  for (const Ring& ring : rings) {
    points.insert(points.end(), ring.begin(), ring.end());
    area += area_of(ring);  // holes are clockwise
  }
  const auto triangles = triangulate_rings(rings);
  EXPECT_EQ(triangles.size(), points.size() + 2 * (rings.size() - 1) - 2);
  double covered = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const double part = area_of(points[a], points[b], points[c]);
    EXPECT_GE(part, -1e-9 * area);
    covered += part;
  }
  EXPECT_NEAR(covered, area, 1e-9 * area);
}

/// A star with a lattice of holes in its middle.
std::vector<Ring> perforated(int corners, int holes_a_side, Random* random) {
  std::vector<Ring> rings = {star({0, 0}, corners, 80.0, 120.0, random)};
  const double step = 100.0 / holes_a_side;
  for (int i = 0; i < holes_a_side; ++i) {
    for (int k = 0; k < holes_a_side; ++k) {
      const Eigen::Vector2d centre(-50.0 + (i + 0.5) * step, -50.0 + (k + 0.5) * step);
      rings.push_back(star(centre, random->integer(3, 12), 0.1 * step, 0.45 * step, random));
      std::reverse(rings.back().begin(), rings.back().end());
    }
  }
  return rings;
}

TEST(RingTriangles, CoverRaggedOutlinesWithHoles) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    expect_covered(perforated(random.integer(40, 120), random.integer(1, 5), &random));
  }
}

TEST(RingTriangles, CoverOutlinesOfCellsWithCellsForHoles) {
  // Many corners in a row and in a column, as outlines of raster cells have them.
  std::vector<Ring> rings = {{}};
  for (int i = 0; i < 10; ++i) rings[0].emplace_back(i, 0);
  for (int i = 0; i < 10; ++i) rings[0].emplace_back(10, i);
  for (int i = 10; i > 0; --i) rings[0].emplace_back(i, 10);
  for (int i = 10; i > 0; --i) rings[0].emplace_back(0, i);
  for (int i = 1; i < 9; i += 2) {
    for (int k = 1; k < 9; k += 2) {
      rings.push_back({{i, k}, {i, k + 1}, {i + 1, k + 1}, {i + 1, k}});
    }
  }
  expect_covered(rings);
}

TEST(RingTriangles, OfATriangleAreItself) {
  EXPECT_EQ(triangulate_rings({{{0, 0}, {1, 0}, {0, 1}}}).size(), 1u);
}

TEST(RingTriangles, AreAsManyWhereRingsCrossOrCollapse) {
  const Ring outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_EQ(triangulate_rings({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}).size(), 2u);
  EXPECT_EQ(triangulate_rings({{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}).size(), 2u);
  EXPECT_EQ(triangulate_rings({{{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}}).size(), 3u);
  EXPECT_EQ(triangulate_rings({outer, {{20, 1}, {20, 2}, {21, 1}}}).size(), 7u);  // outside
  EXPECT_EQ(triangulate_rings({outer, {{9, 5}, {11, 6}, {11, 5}}}).size(), 7u);   // across
}

TEST(RingTriangles, OfThousandsOfPointsTakeNoMinutes) {
  Random random(3);
  const auto rings = perforated(6000, 15, &random);
  const auto start = std::chrono::steady_clock::now();
  expect_covered(rings);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

}  // namespace
}  // namespace gable
