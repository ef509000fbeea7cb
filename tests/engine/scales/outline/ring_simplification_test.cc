#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gable {
namespace {

double distance_to_ring(const Eigen::Vector2d& p, const Ring& ring) {
  double nearest = 1e9;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i], b = ring[(i + 1) % ring.size()];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * (b - a)).norm());
  }
  return nearest;
}

TEST(SignedArea, IsPositiveAnticlockwise) {
  EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {2, 0}, {2, 3}, {0, 3}}), 6.0);
  EXPECT_DOUBLE_EQ(signed_area({{0, 0}, {0, 3}, {2, 3}, {2, 0}}), -6.0);
}

TEST(AreSimple, KnowsRingsThatMeet) {
  const Ring square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  EXPECT_TRUE(are_simple({square}));
  EXPECT_FALSE(are_simple({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}));          // a bow tie
  EXPECT_FALSE(are_simple({{{0, 0}, {4, 0}, {4, 4}, {4, 1}, {0, 1}}}));  // a spike
  EXPECT_FALSE(are_simple({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}));  // a corner on an edge
  EXPECT_TRUE(are_simple({square, {{1, 1}, {1, 2}, {2, 2}}}));           // a hole
  EXPECT_FALSE(are_simple({square, {{3, 1}, {3, 2}, {5, 2}}}));          // a hole that leaves
  EXPECT_FALSE(are_simple({square, {{4, 1}, {3, 2}, {3, 1}}}));          // a hole that touches
}

TEST(Simplified, LeavesOutWhatLiesOnALine) {
  Ring ring;
  for (int i = 0; i < 10; ++i) ring.emplace_back(i, 0.01 * (i % 2));
  for (int i = 0; i < 10; ++i) ring.emplace_back(10 + 0.01 * (i % 2), i);
  for (int i = 0; i < 10; ++i) ring.emplace_back(10 - i, 10);
  for (int i = 0; i < 10; ++i) ring.emplace_back(0, 10 - i);
  const std::vector<Ring> out = simplified({ring}, 0.1);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].size(), 4u);
  EXPECT_NEAR(signed_area(out[0]), 100.0, 0.2);
}

TEST(Simplified, StaysWithinItsToleranceAndSimple) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    Ring ring;
    for (int i = 0; i < 400; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 400;
      const double radius = random.uniform(2.0, 4.0);
      ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    ASSERT_TRUE(are_simple({ring}));
    for (const double tolerance : {0.1, 0.5, 1.0}) {
      const std::vector<Ring> out = simplified({ring}, tolerance);
      ASSERT_EQ(out.size(), 1u);
      EXPECT_TRUE(are_simple(out)) << seed;
      for (const Eigen::Vector2d& p : ring) {
        EXPECT_LE(distance_to_ring(p, out[0]), tolerance + 1e-9) << seed;
      }
    }
  }
}

}  // namespace
}  // namespace gable
