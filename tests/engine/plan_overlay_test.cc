#include <gable/engine/plan_overlay.h>
#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

PlanPolygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

bool holds(const PlanShape& shape, const Eigen::Vector2d& p) {
  for (const PlanPolygon& polygon : shape) {
    if (polygon_holds(polygon, p)) return true;
  }
  return false;
}

TEST(PlanOverlay, TwoBoxesHaveTheAreasOfTheirParts) {
  const PlanShape a = {box(0, 0, 4, 3)}, b = {box(3, 1, 6, 2)};
  EXPECT_NEAR(area_of(common_of(a, b)), 1.0, 1e-12);
  EXPECT_NEAR(area_of(union_of(a, b)), 14.0, 1e-12);
  EXPECT_NEAR(area_of(difference_of(a, b)), 11.0, 1e-12);
  EXPECT_NEAR(area_of(difference_of(b, a)), 2.0, 1e-12);
}

TEST(PlanOverlay, OuterRingsRunAnticlockwiseAndHolesClockwise) {
  const PlanShape frame = difference_of({box(0, 0, 10, 10)}, {box(2, 2, 8, 8)});
  ASSERT_EQ(frame.size(), 1u);
  ASSERT_EQ(frame.front().holes.size(), 1u);
  EXPECT_NEAR(signed_area(frame.front().outer), 100.0, 1e-12);
  EXPECT_NEAR(signed_area(frame.front().holes.front()), -36.0, 1e-12);
  EXPECT_NEAR(area_of(frame), 64.0, 1e-12);
}

TEST(PlanOverlay, BoxesThatTouchHaveNothingInCommon) {
  EXPECT_TRUE(common_of({box(0, 0, 4, 3)}, {box(4, 0, 6, 3)}).empty());
  EXPECT_EQ(union_of({box(0, 0, 4, 3)}, {box(4, 0, 6, 3)}).size(), 1u);
}

TEST(PlanOverlay, NothingIsTheNeutralElement) {
  const PlanShape a = {box(0, 0, 4, 3)};
  EXPECT_NEAR(area_of(union_of(a, {})), 12.0, 1e-12);
  EXPECT_NEAR(area_of(difference_of(a, {})), 12.0, 1e-12);
  EXPECT_TRUE(common_of(a, {}).empty());
  EXPECT_TRUE(difference_of({}, a).empty());
}

TEST(PlanOverlay, WhatIsMovedKeepsItsAreaAndTakesItsHolesAlong) {
  const PlanShape frame = difference_of({box(0, 0, 10, 10)}, {box(2, 2, 8, 8)});
  const PlanShape away = moved(frame, {20.0, -5.0});
  EXPECT_NEAR(area_of(away), 64.0, 1e-12);
  EXPECT_NEAR(area_of(common_of(away, {box(20, -5, 30, 5)})), 64.0, 1e-9);
}

TEST(PlanOverlay, EveryPointIsWhereThePartsSayItIs) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const auto triangles = [&] {
      PlanShape shape;
      for (int k = 0; k < 3; ++k) {
        Ring ring;
        for (int i = 0; i < 3; ++i) {
          ring.emplace_back(random.uniform(0.0, 5.0), random.uniform(0.0, 5.0));
        }
        if (signed_area(ring) < 0.0) std::swap(ring[0], ring[1]);
        shape = union_of(shape, {{ring, {}}});
      }
      return shape;
    };
    const PlanShape a = triangles(), b = triangles();
    const PlanShape all = union_of(a, b), both = common_of(a, b), rest = difference_of(a, b);
    int wrong = 0;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d p(random.uniform(0.0, 5.0), random.uniform(0.0, 5.0));
      wrong += holds(all, p) != (holds(a, p) || holds(b, p));
      wrong += holds(both, p) != (holds(a, p) && holds(b, p));
      wrong += holds(rest, p) != (holds(a, p) && !holds(b, p));
    }
    // Points may fall into slivers, which are dropped.
    EXPECT_LE(wrong, 1) << trial;
  }
}

}  // namespace
}  // namespace gable
