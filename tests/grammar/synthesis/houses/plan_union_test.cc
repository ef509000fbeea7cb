#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

Ring rectangle(double x0, double x1, double y0, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

double area(const PlanPolygon& polygon) {
  double sum = signed_area(polygon.outer);
  for (const Ring& hole : polygon.holes) sum += signed_area(hole);
  return sum;
}

TEST(PlanUnion, OfCrossingRectanglesHasTheirCommonAreaOnce) {
  const PlanPolygon plus = union_of_convex({rectangle(-5, 5, -1, 1), rectangle(-1, 1, -4, 4)});
  EXPECT_EQ(plus.outer.size(), 12u);
  EXPECT_TRUE(plus.holes.empty());
  EXPECT_NEAR(area(plus), 20.0 + 16.0 - 4.0, 0.3);
}

TEST(PlanUnion, OfRectanglesThatShareAWallIsOnePiece) {
  const PlanPolygon row =
      union_of_convex({rectangle(0, 5, 0, 4), rectangle(5, 9, 0, 4), rectangle(9, 12, 0, 4)});
  EXPECT_EQ(row.outer.size(), 4u);
  EXPECT_NEAR(area(row), 48.0, 0.2);
}

TEST(PlanUnion, OfFourWingsHasACourt) {
  const PlanPolygon court = union_of_convex({rectangle(0, 10, 0, 3), rectangle(0, 10, 7, 10),
                                             rectangle(0, 3, 0, 10), rectangle(7, 10, 0, 10)});
  ASSERT_EQ(court.holes.size(), 1u);
  EXPECT_NEAR(signed_area(court.outer), 100.0, 0.2);
  EXPECT_NEAR(signed_area(court.holes[0]), -16.0, 0.1);
}

TEST(PlanUnion, HoldsThePointsThatAnyRingHolds) {
  Random random(1);
  for (int house = 0; house < 50; ++house) {
    std::vector<Ring> rings;
    for (int i = 0; i < 6; ++i) {
      // All through the origin, so that the union is one piece.
      const double angle = random.uniform(0.0, 2.0 * M_PI);
      const Eigen::Vector2d u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
      const double l = random.uniform(2.0, 8.0), w = random.uniform(0.5, 4.0);
      const Eigen::Vector2d c = random.uniform(-0.9, 0.9) * l * u;
      rings.push_back({c - l * u - w * v, c + l * u - w * v, c + l * u + w * v, c - l * u + w * v});
    }
    const PlanPolygon polygon = union_of_convex(rings);
    int differ = 0;
    for (int i = 0; i < 1000; ++i) {
      const Eigen::Vector2d p(random.uniform(-16.0, 16.0), random.uniform(-16.0, 16.0));
      bool inside = ring_holds(polygon.outer, p);
      for (const Ring& hole : polygon.holes) inside = inside && !ring_holds(hole, p);
      differ += inside != std::any_of(rings.begin(), rings.end(),
                                      [&](const Ring& ring) { return ring_holds(ring, p); });
    }
    EXPECT_LE(differ, 3) << "house " << house;  // within millimetres of an edge
  }
}

TEST(PlanUnion, DistanceIsThatOfTheNearestPoints) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(-12.0, 12.0), y = random.uniform(-12.0, 12.0);
    const Ring a = rectangle(0, 4, 0, 2), b = rectangle(x, x + 3, y, y + 5);
    const double dx = std::max({0.0, x - 4.0, -(x + 3.0)});
    const double dy = std::max({0.0, y - 2.0, -(y + 5.0)});
    EXPECT_NEAR(ring_distance(a, b), std::hypot(dx, dy), 1e-9);
    EXPECT_NEAR(ring_distance(b, a), std::hypot(dx, dy), 1e-9);
  }
}

TEST(PlanUnion, DistanceIsNoneInsideAndAcross) {
  EXPECT_EQ(ring_distance(rectangle(0, 9, 0, 9), rectangle(3, 4, 3, 4)), 0.0);
  EXPECT_EQ(ring_distance(rectangle(3, 4, 3, 4), rectangle(0, 9, 0, 9)), 0.0);
  EXPECT_EQ(ring_distance(rectangle(-5, 5, -1, 1), rectangle(-1, 1, -5, 5)), 0.0);
}

}  // namespace
}  // namespace gable
