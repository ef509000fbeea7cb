#include <gable/engine/closing/plan_division.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

TEST(PlanDivision, TwoLinesMakeFourCellsWithFourBorders) {
  const auto division = PlanDivision::make(
      rectangle(0, 0, 10, 6), {{Eigen::Vector2d::UnitX(), 4.0}, {Eigen::Vector2d::UnitY(), 1.0}});
  ASSERT_TRUE(division);
  EXPECT_EQ(division->num_cells(), 4);
  EXPECT_EQ(division->borders().size(), 4u);
  EXPECT_NEAR(division->area(division->cell_at({1.0, 0.5})), 4.0, 1e-12);
  EXPECT_NEAR(division->area(division->cell_at({9.0, 5.0})), 30.0, 1e-12);
  EXPECT_EQ(division->cell_at({-1.0, 0.5}), -1);
}

TEST(PlanDivision, PiecesThatALineCutsOffOnOneSideAreCellsOfTheirOwn) {
  // A U: the line y = 5 cuts off both of its arms, on the same side.
  const PlanPolygon u{{{0, 0}, {9, 0}, {9, 9}, {6, 9}, {6, 3}, {3, 3}, {3, 9}, {0, 9}}, {}};
  const auto division = PlanDivision::make(u, {{Eigen::Vector2d::UnitY(), 5.0}});
  ASSERT_TRUE(division);
  EXPECT_EQ(division->num_cells(), 3);
  EXPECT_NE(division->cell_at({1.0, 8.0}), division->cell_at({8.0, 8.0}));
}

TEST(PlanDivision, CellsOfRandomLinesCoverTheOutlineOnce) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    PlanPolygon outline = rectangle(-6, -5, 7, 6);
    outline.holes.push_back({{0, 0}, {2, 0.3}, {1, 2}});
    std::vector<PlanLine> lines;
    for (int i = 0; i < 12; ++i) {
      const double angle = random.uniform(0, M_PI);
      lines.push_back({{std::cos(angle), std::sin(angle)}, random.uniform(-5, 5)});
    }
    const auto division = PlanDivision::make(outline, lines);
    ASSERT_TRUE(division);
    double area = 0.0;
    for (int c = 0; c < division->num_cells(); ++c) area += division->area(c);
    EXPECT_NEAR(area, 13 * 11 - std::abs(signed_area(outline.holes[0])), 1e-4);
    // A cell lies on one side of every line, which may have moved by 3 cm.
    for (const HeightSample& s : sample_roof(
             outline, [](const auto&) { return 0; }, 0.9, 0, 1)) {
      const int cell = division->cell_at(s.point.head<2>());
      ASSERT_GE(cell, 0);
      for (const PlanLine& line : lines) {
        const double at_sample = line.signed_distance(s.point.head<2>());
        if (std::abs(at_sample) <= 0.03) continue;
        for (const Eigen::Vector2d& corner : division->corners(cell)) {
          EXPECT_GT(std::copysign(1.0, at_sample) * line.signed_distance(corner), -0.0301);
        }
      }
    }
  }
}

TEST(PlanDivision, LinesPassCornersExactlyOrClearOfThem) {
  // The second line would pass the corner where the first one meets the outline by 1 mm, the third
  // goes through it.
  const PlanLine first{Eigen::Vector2d::UnitX(), 4.0};
  const Eigen::Vector2d normal = Eigen::Vector2d(1, 1).normalized();
  const auto corners_near = [&](const PlanLine& line) {
    const auto division = PlanDivision::make(rectangle(0, 0, 10, 6), {first, line});
    EXPECT_TRUE(division);
    std::vector<double> apart;
    for (int c = 0; c < division->num_cells(); ++c) {
      for (const Eigen::Vector2d& p : division->corners(c)) {
        const double distance = (p - Eigen::Vector2d(4, 0)).norm();
        if (distance < 1.0) apart.push_back(distance);
      }
    }
    return apart;
  };
  bool moved = false;
  for (const double d : corners_near({normal, normal.x() * 4.0 + 0.001})) {
    EXPECT_TRUE(d < 1e-9 || d > 0.005);
    moved = moved || d > 0.005;
  }
  EXPECT_TRUE(moved);
  for (const double d : corners_near({normal, normal.x() * 4.0})) EXPECT_LT(d, 1e-9);
}

TEST(PlanDivision, LineEndsAtTheNextEarlierLineBeyondWhatWasSeenOfIt) {
  const PlanLine across{Eigen::Vector2d::UnitX(), 4.0};
  PlanLine along{Eigen::Vector2d::UnitY(), 3.0};  // its direction is -x
  along.begin = -9.0;
  along.end = -6.0;
  const auto division = PlanDivision::make(rectangle(0, 0, 10, 6), {across, along});
  ASSERT_TRUE(division);
  EXPECT_EQ(division->num_cells(), 3);
  EXPECT_NEAR(division->area(division->cell_at({1.0, 5.0})), 24.0, 1e-12);
  EXPECT_NEAR(division->area(division->cell_at({5.0, 5.0})), 18.0, 1e-12);
  EXPECT_NE(division->cell_at({5.0, 5.0}), division->cell_at({5.0, 1.0}));
}

TEST(PlanDivision, InsideOfACellIsInIt) {
  PlanPolygon outline = rectangle(0, 0, 9, 9);
  outline.holes.push_back({{2, 2}, {8, 2}, {8, 8}, {2, 8}});
  std::vector<PlanLine> lines;
  for (int i = 0; i < 8; ++i) lines.push_back({{std::cos(0.4 * i), std::sin(0.4 * i)}, 1.0 + i});
  const auto division = PlanDivision::make(outline, lines);
  ASSERT_TRUE(division);
  for (int c = 0; c < division->num_cells(); ++c) {
    EXPECT_EQ(division->cell_at(division->inside(c)), c);
  }
}

TEST(PlanDivision, OutlinesWithoutAreaCannotBeDivided) {
  EXPECT_FALSE(PlanDivision::make({}, {}));
  EXPECT_FALSE(PlanDivision::make({{{0, 0}, {1, 0}}, {}}, {}));
  EXPECT_FALSE(PlanDivision::make({{{0, 0}, {1, 0}, {NAN, 1}}, {}}, {}));
}

}  // namespace
}  // namespace gable
