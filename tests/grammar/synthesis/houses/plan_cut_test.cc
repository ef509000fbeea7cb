#include <gable/grammar/synthesis/houses/plan_cut.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

PlanPolygon rectangle(double size_x, double size_y) {
  return {{{0.0, 0.0}, {size_x, 0.0}, {size_x, size_y}, {0.0, size_y}}, {}};
}

double area(const std::vector<Eigen::Vector2d>& ring) {
  double sum = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

TEST(PlanCut, ObliqueCutTakesTheTriangleAtTheEnd) {
  const double angle = 0.3;
  for (bool left : {false, true}) {
    const PlanPolygon cut = cut_obliquely(rectangle(5.0, 9.0), {0.0, 1.0}, angle, left);
    EXPECT_NEAR(area(cut.outer), 45.0 - 0.5 * 25.0 * std::tan(angle), 1e-9);
    // The corner that the line leaves from stays; the other goes.
    const Eigen::Vector2d kept(left ? 0.0 : 5.0, 9.0);
    const auto is = [](const Eigen::Vector2d& p) {
      return [p](const Eigen::Vector2d& q) { return (p - q).norm() < 1e-9; };
    };
    EXPECT_TRUE(std::any_of(cut.outer.begin(), cut.outer.end(), is(kept)));
    EXPECT_FALSE(std::any_of(cut.outer.begin(), cut.outer.end(), is({5.0 - kept.x(), 9.0})));
  }
}

TEST(PlanCut, CutsTheEndThatItIsAskedTo) {
  const PlanPolygon cut = cut_obliquely(rectangle(5.0, 9.0), {0.0, -1.0}, 0.3, true);
  EXPECT_NEAR(area(cut.outer), 45.0 - 0.5 * 25.0 * std::tan(0.3), 1e-9);
  EXPECT_TRUE(inside_ring(cut.outer, {0.1, 8.9}));
  EXPECT_TRUE(inside_ring(cut.outer, {4.9, 8.9}));
}

TEST(PlanCut, NarrowEndIsCutAtItsOwnCorners) {
  // A strip of 2 m at the end of a body of 5 m.
  const PlanPolygon outline = {{{0, 0}, {5, 0}, {5, 6}, {2, 6}, {2, 10}, {0, 10}}, {}};
  const PlanPolygon cut = cut_obliquely(outline, {0.0, 1.0}, 0.4, true);
  EXPECT_NEAR(area(cut.outer), 38.0 - 0.5 * 4.0 * std::tan(0.4), 1e-9);
}

TEST(PlanCut, InsideRingAgreesWithSidesOfATriangle) {
  const std::vector<Eigen::Vector2d> triangle = {{0, 0}, {4, 1}, {1, 5}};
  for (double x = -0.95; x < 5.0; x += 0.3) {
    for (double y = -0.95; y < 6.0; y += 0.3) {
      bool expected = true;
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d a = triangle[i], e = triangle[(i + 1) % 3] - a;
        expected &= e.x() * (y - a.y()) - e.y() * (x - a.x()) > 0.0;
      }
      EXPECT_EQ(inside_ring(triangle, {x, y}), expected);
    }
  }
}

TEST(PlanCut, RegisterMovesRigidlyWithinItsError) {
  Random random(1);
  const PlanPolygon outline = rectangle(6.0, 9.0);
  double farthest = 0.0;
  for (int i = 0; i < 300; ++i) {
    const PlanPolygon moved = register_outline(outline, 0.5, &random);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const auto& p : moved.outer) middle += 0.25 * p;
    const Eigen::Vector2d by = middle - Eigen::Vector2d(3.0, 4.5);
    EXPECT_LE(by.cwiseAbs().maxCoeff(), 0.5 + 1e-9);
    farthest = std::max(farthest, by.norm());
    EXPECT_NEAR(area(moved.outer), 54.0, 1e-9);
    const Eigen::Vector2d edge = moved.outer[1] - moved.outer[0];
    EXPECT_LE(std::abs(std::atan2(edge.y(), edge.x())), M_PI / 180.0 + 1e-9);
  }
  EXPECT_GT(farthest, 0.3);
}

}  // namespace
}  // namespace gable
