#include <gable/engine/reconstruct/building/snapped_outline.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/ring.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

constexpr double kAzimuth = 0.4;

PlanPolygon turned(Ring ring) {
  for (Eigen::Vector2d& p : ring) p = Eigen::Rotation2Dd(kAzimuth) * p;
  return {ring, {}};
}

void expect_corners(const PlanPolygon& polygon, const Ring& house_frame) {
  ASSERT_EQ(polygon.outer.size(), house_frame.size());
  for (const Eigen::Vector2d& corner : turned(house_frame).outer) {
    double nearest = 1e300;
    for (const Eigen::Vector2d& p : polygon.outer) nearest = std::min(nearest, (p - corner).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

// Walls at x = -5 and 5, y = -3 and 3 of the house frame.
const House kHouse = box_house(10.0, 6.0, gable_roof(3.0, 3.0, Axis::kX), kAzimuth);

TEST(SnappedOutline, CornersNearWallsComeToLieOnThemAndOthersStay) {
  const PlanPolygon outline = turned({{-5.1, -3.0}, {2.0, -3.15}, {4.0, 3.1}, {-4.85, 2.9}});
  expect_corners(snapped_to_blocks(outline, kHouse, 0.2),
                 {{-5.0, -3.0}, {2.0, -3.0}, {4.0, 3.0}, {-5.0, 3.0}});
}

TEST(SnappedOutline, StepsThatVanishLeaveNoCorners) {
  const PlanPolygon outline =
      turned({{-5.0, -3.1}, {0.0, -3.1}, {0.0, -2.9}, {5.0, -2.9}, {5.0, 3.0}, {-5.0, 3.0}});
  expect_corners(snapped_to_blocks(outline, kHouse, 0.2),
                 {{-5.0, -3.0}, {5.0, -3.0}, {5.0, 3.0}, {-5.0, 3.0}});
}

TEST(SnappedOutline, WallsFarAlongThemselvesDrawNothing) {
  // The second corner is near the line of the south wall, 4 m beyond its end.
  const PlanPolygon outline = turned({{-5.0, -2.0}, {9.0, -2.9}, {9.0, 2.0}, {-5.0, 2.0}});
  expect_corners(snapped_to_blocks(outline, kHouse, 0.2),
                 {{-5.0, -2.0}, {9.0, -2.9}, {9.0, 2.0}, {-5.0, 2.0}});
}

TEST(SnappedOutline, OneThatWouldLoseItsAreaStays) {
  const PlanPolygon strip = turned({{-5.0, 2.9}, {5.0, 2.9}, {5.0, 3.1}, {-5.0, 3.1}});
  expect_corners(snapped_to_blocks(strip, kHouse, 0.2),
                 {{-5.0, 2.9}, {5.0, 2.9}, {5.0, 3.1}, {-5.0, 3.1}});
}

TEST(SnappedOutline, IsSimpleAndMovesNoCornerFartherThanTheToleranceAlongAnAxis) {
  Random random(6);
  int moved = 0;
  for (int i = 0; i < 500; ++i) {
    Ring ring;
    const int corners = random.integer(3, 9);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * (k + random.uniform(0.0, 0.8)) / corners;
      const double radius = random.uniform(2.0, 7.0);
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    if (!are_simple({ring})) continue;
    const PlanPolygon snapped = snapped_to_blocks(turned(ring), kHouse, 0.2);
    EXPECT_TRUE(are_simple({snapped.outer}));
    EXPECT_GE(snapped.outer.size(), 3u);
    for (const Eigen::Vector2d& p : snapped.outer) {
      double nearest = 1e300;
      for (const Eigen::Vector2d& q : turned(ring).outer) {
        nearest = std::min(nearest, (p - q).norm());
      }
      EXPECT_LT(nearest, 0.2 * std::sqrt(2.0) + 1e-9);
      moved += nearest > 1e-9;
    }
  }
  EXPECT_GT(moved, 50);
}

}  // namespace
}  // namespace gable
