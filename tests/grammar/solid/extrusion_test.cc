#include <gable/grammar/random.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

double volume_if_valid(const Solid& solid) {
  const SolidValidity validity = check_solid(solid);
  EXPECT_EQ(validity.describe(), "valid");
  return validity.volume;
}

TEST(Extrusion, SquareBecomesABoxInEitherOrientation) {
  PlanPolygon square{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}};
  for (int turn = 0; turn < 2; ++turn) {
    const Solid solid = extrude(square, -0.5, 5.0);
    EXPECT_EQ(solid.vertices.size(), 8u);
    EXPECT_EQ(solid.faces.size(), 6u);
    EXPECT_NEAR(volume_if_valid(solid), 4 * 3 * 5.5, 1e-9);
    std::reverse(square.outer.begin(), square.outer.end());
  }
}

TEST(Extrusion, HoleBecomesACourtyard) {
  const PlanPolygon polygon{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {6, 3}, {6, 6}, {3, 6}}}};
  const Solid solid = extrude(polygon, 0.0, 2.0);
  EXPECT_EQ(solid.faces.size(), 10u);
  EXPECT_NEAR(volume_if_valid(solid), (81 - 9) * 2.0, 1e-9);
}

TEST(Extrusion, RepeatedAndCollinearPointsAreRemoved) {
  const PlanPolygon polygon{{{0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 0.001}, {4, 3}, {0, 3}, {0, 1e-4}},
                            {}};
  const Solid solid = extrude(polygon, 0.0, 2.0);
  EXPECT_EQ(solid.faces.size(), 6u);
  EXPECT_NEAR(volume_if_valid(solid), 24.0, 0.1);
}

TEST(Extrusion, RingThatTouchesItselfStaysValid) {
  // Two squares that meet in a corner, and a ring round a courtyard that it touches in a corner.
  const PlanPolygon corner{{{0, 0}, {4, 0}, {4, 4}, {7, 4}, {7, 7}, {4, 7}, {4, 4}, {0, 4}}, {}};
  EXPECT_NEAR(volume_if_valid(extrude(corner, 0.0, 1.0)), 16.0, 1e-6);
  const PlanPolygon courtyard{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{0, 0}, {4, 2}, {4, 4}, {2, 4}}}};
  EXPECT_NEAR(volume_if_valid(extrude(courtyard, 0.0, 1.0)), 81.0 - 8.0, 0.5);
}

TEST(Extrusion, FigureOfEightGivesItsLargerLoop) {
  const PlanPolygon eight{{{0, 0}, {6, 6}, {6, 0}, {0, 2}}, {}};
  const double x = 1.5;  // where (0,0)-(6,6) crosses (6,0)-(0,2)
  EXPECT_NEAR(volume_if_valid(extrude(eight, 0.0, 1.0)), 0.5 * 6.0 * (6.0 - x), 1e-6);
}

TEST(Extrusion, NothingComesOfNothing) {
  EXPECT_TRUE(extrude({}, 0.0, 1.0).faces.empty());
  EXPECT_TRUE(extrude({{{0, 0}, {1, 1}}, {}}, 0.0, 1.0).faces.empty());
  EXPECT_TRUE(extrude({{{0, 0}, {1, 1}, {2, 2}}, {}}, 0.0, 1.0).faces.empty());
  EXPECT_TRUE(extrude({{{0, 0}, {1, 0}, {1, 1}}, {}}, 1.0, 1.0).faces.empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(extrude({{{0, 0}, {nan, 0}, {1, 1}}, {}}, 0.0, 1.0).faces.empty());
}

TEST(Extrusion, RandomStarsHaveTheirPolygonsVolume) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    PlanPolygon star;
    const int n = random.integer(3, 40);
    double twice_area = 0.0;
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * M_PI * k / n, radius = random.uniform(3.0, 12.0);
      star.outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    for (int k = 0; k < n; ++k) {
      const Eigen::Vector2d &a = star.outer[k], &b = star.outer[(k + 1) % n];
      twice_area += a.x() * b.y() - a.y() * b.x();
    }
    EXPECT_NEAR(volume_if_valid(extrude(star, 0.0, 2.0)), twice_area, 1e-3 * twice_area);
  }
}

// The outline of a random set of raster cells that touch in corners, as contour tracing gives it.
TEST(Extrusion, CheckeredOutlinesStayValid) {
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    PlanPolygon polygon;
    const int n = random.integer(3, 9);
    for (int k = 0; k < n; ++k) {  // a staircase of diagonal cells there and back
      polygon.outer.emplace_back(k, k);
      polygon.outer.emplace_back(k + 1, k);
    }
    polygon.outer.emplace_back(n, n);
    for (int k = n; k-- > 0;) {
      polygon.outer.emplace_back(k, k + 1);
      polygon.outer.emplace_back(k, k);
    }
    polygon.outer.pop_back();
    for (Eigen::Vector2d& p : polygon.outer) p *= random.chance(0.5) ? 1.0 : 1.0 + 1e-4;
    volume_if_valid(extrude(polygon, 0.0, 2.0));
  }
}

}  // namespace
}  // namespace gable
