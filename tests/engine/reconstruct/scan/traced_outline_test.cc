#include <gable/engine/reconstruct/scan/traced_outline.h>
#include <gable/grammar/ring.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gable {
namespace {

// The trace of a wall from one point to another.
PlanLine trace(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  PlanLine line;
  const Eigen::Vector2d along = (to - from).normalized();
  line.normal = {along.y(), -along.x()};
  line.offset = line.normal.dot(from);
  line.begin = line.along(from);
  line.end = line.along(to);
  return line;
}

const std::vector<PlanLine> kWalls = {trace({0, 0}, {10, 0}), trace({10, 0}, {10, 6}),
                                      trace({10, 6}, {0, 6}), trace({0, 6}, {0, 0})};

TEST(TracedOutline, CornersAreWhereWallsCross) {
  const PlanPolygon outline{{{-0.1, -0.2}, {10.2, 0.1}, {10.1, 6.2}, {-0.2, 5.9}}, {}};
  const PlanPolygon traced = traced_outline(outline, kWalls, 0.5);
  ASSERT_EQ(traced.outer.size(), 4u);
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {10, 0}, {10, 6}, {0, 6}};
  for (size_t i = 0; i < 4; ++i) EXPECT_LT((traced.outer[i] - corners[i]).norm(), 1e-12);
}

TEST(TracedOutline, EdgesOfOneWallBecomeOne) {
  const PlanPolygon outline{{{0, -0.2}, {4, 0.3}, {10.2, -0.1}, {10, 6.1}, {6, 6.4}, {0, 6}}, {}};
  EXPECT_EQ(traced_outline(outline, kWalls, 0.5).outer.size(), 4u);
}

TEST(TracedOutline, EdgesWithoutAWallStay) {
  // The walls are seen on two sides alone.
  const PlanPolygon outline{{{0, -0.2}, {10.2, 0}, {10.1, 6.3}, {-0.1, 6.2}}, {}};
  const PlanPolygon traced = traced_outline(outline, {kWalls[0], kWalls[1]}, 0.5);
  ASSERT_EQ(traced.outer.size(), 4u);
  EXPECT_NEAR(traced.outer[1].x(), 10.0, 1e-12);
  EXPECT_NEAR(traced.outer[1].y(), 0.0, 1e-12);
  EXPECT_EQ(traced.outer[3], outline.outer[3]);
  // Seen too shortly, or too far away.
  EXPECT_EQ(traced_outline(outline, {trace({0, 0}, {4, 0})}, 0.5).outer, outline.outer);
  EXPECT_EQ(traced_outline(outline, kWalls, 0.05).outer, outline.outer);
}

TEST(TracedOutline, CornerBetweenParallelWallsBecomesAJog) {
  const PlanPolygon outline{{{0, 0}, {5, 0.2}, {10, 0.4}, {10, 6}, {0, 6}}, {}};
  const PlanPolygon traced =
      traced_outline(outline, {trace({0, 0}, {5, 0}), trace({5, 0.4}, {10, 0.4})}, 0.5);
  ASSERT_EQ(traced.outer.size(), 6u);
  EXPECT_NEAR(signed_area(traced.outer), 60 - 5 * 0.4, 1e-9);
}

TEST(TracedOutline, RingsThatWouldCrossStay) {
  // The courtyard is nearer to the outer walls than the distance.
  const PlanPolygon outline{{{0, 0}, {10, 0}, {10, 6}, {0, 6}},
                            {{{0.3, 0.4}, {9.7, 0.4}, {9.7, 5}, {0.3, 5}}}};
  const PlanPolygon traced = traced_outline(outline, kWalls, 0.5);
  EXPECT_EQ(traced.holes[0], outline.holes[0]);
}

}  // namespace
}  // namespace gable
