#include <gable/engine/closing/plan_mending.h>
#include <gable/engine/closing/roof_defects.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

constexpr double kClearance = 0.1;

// A plan of 5 m by 7 m in four cells of 6, 9, 12 and 8 m2, anticlockwise from the lower left.
constexpr std::array<double, 4> kAreas = {6.0, 9.0, 12.0, 8.0};

LabelledPlan quarters() {
  const PlanPolygon outline = rectangle(0, 0, 5, 7);
  const std::vector<PlanLine> lines = {{Eigen::Vector2d::UnitX(), 2.0},
                                       {Eigen::Vector2d::UnitY(), 3.0}};
  LabelledPlan plan{outline, lines, *PlanDivision::make(outline, lines), {}, 0.0};
  plan.labels.resize(plan.division.num_cells());
  const std::array<Eigen::Vector2d, 4> places = {Eigen::Vector2d(1, 1), {4, 1}, {4, 5}, {1, 5}};
  for (int i = 0; i < 4; ++i) plan.labels[plan.division.cell_at(places[i])] = i;
  return plan;
}

PlaneChoice level_planes(const std::vector<double>& heights) {
  PlaneChoice choice;
  for (size_t i = 0; i < heights.size(); ++i) {
    choice.add({0, 0, heights[i]}, static_cast<int>(i), {});
  }
  return choice;
}

double volume_of(const std::vector<Solid>& solids) {
  double volume = 0.0;
  for (const Solid& solid : solids) {
    const SolidValidity validity = check_solid(solid);
    EXPECT_EQ(validity.describe(), "valid");
    volume += validity.volume;
  }
  return volume;
}

TEST(PlanMending, PlanWithoutDefectsStaysAsItIs) {
  const auto mended = mend_plan(quarters(), level_planes({3, 4, 5, 4.5}), 1.0, kClearance);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->cells, 4);
  EXPECT_EQ(mended->origins, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_NEAR(volume_of(mended->solids),
              2 * kAreas[0] + 3 * kAreas[1] + 4 * kAreas[2] + 3.5 * kAreas[3], 1e-9);
}

TEST(PlanMending, PlanesThatNoCellUsesAreLeftOut) {
  LabelledPlan plan = quarters();
  for (int& label : plan.labels) label += label >= 2;
  const auto mended = mend_plan(plan, level_planes({3, 4, 9, 5, 4.5}), 0.0, kClearance);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->roof.planes.size(), 4u);
  EXPECT_EQ(mended->origins, (std::vector<int>{0, 1, 3, 4}));
}

TEST(PlanMending, SmallestCellAtASaddleGetsThePlaneNextInHeight) {
  const auto mended = mend_plan(quarters(), level_planes({5, 3, 4, 3.5}), 0.0, kClearance);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->cells, 4);
  EXPECT_EQ(mended->origins, (std::vector<int>{1, 2, 3}));
  EXPECT_NEAR(volume_of(mended->solids),
              3.5 * kAreas[0] + 3 * kAreas[1] + 4 * kAreas[2] + 3.5 * kAreas[3], 1e-9);
}

TEST(PlanMending, CellsAtASaddleGetNoPlaneTooLowAboveTheBase) {
  // Both planes beside the smallest cell are less than 2.1 m above the base, so the next larger
  // cell gets the plane of the one beside it.
  const auto mended = mend_plan(quarters(), level_planes({5, 3, 4, 3.5}), 1.5, 2.1);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->origins, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(volume_of(mended->solids),
              3.5 * kAreas[0] + 1.5 * kAreas[1] + 2.5 * kAreas[2] + 2.5 * kAreas[3], 1e-9);
}

TEST(PlanMending, OfTwoPlanesNearlyAtOneHeightOneMovesByTwoCentimetresAtMost) {
  const std::vector<double> heights = {3, 3.002, 5, 4};
  const auto mended = mend_plan(quarters(), level_planes(heights), 0.0, kClearance);
  ASSERT_TRUE(mended);
  EXPECT_EQ(mended->origins, (std::vector<int>{0, 1, 2, 3}));
  const RoofDefects defects = find_roof_defects(mended->roof, 0.004);
  EXPECT_TRUE(defects.crowded.empty());
  EXPECT_TRUE(defects.saddles.empty());
  double volume = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double height = mended->roof.planes[i].c;
    EXPECT_NEAR(height, heights[i], i == 0 ? 0.02 : 0.0);
    volume += height * kAreas[i];
  }
  EXPECT_GE(std::abs(mended->roof.planes[0].c - mended->roof.planes[1].c), 0.004);
  EXPECT_NEAR(volume_of(mended->solids), volume, 1e-9);
}

TEST(PlanMending, SamePlanIsMendedTheSame) {
  const PlaneChoice choice = level_planes({3, 3.002, 5, 4});
  const auto once = mend_plan(quarters(), choice, 0.0, kClearance);
  const auto again = mend_plan(quarters(), choice, 0.0, kClearance);
  ASSERT_TRUE(once && again);
  ASSERT_EQ(once->solids.size(), again->solids.size());
  for (size_t i = 0; i < once->solids.size(); ++i) {
    EXPECT_EQ(once->solids[i].vertices, again->solids[i].vertices);
  }
}

TEST(PlanMending, RoofBelowTheBaseHasNoSolids) {
  EXPECT_FALSE(mend_plan(quarters(), level_planes({3, 4, 5, 4.5}), 3.5, kClearance));
}

}  // namespace
}  // namespace gable
