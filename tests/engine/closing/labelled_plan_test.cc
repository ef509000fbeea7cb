#include <gable/engine/closing/labelled_plan.h>
#include <gtest/gtest.h>

#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

// A plan of 6 m by 4 m, divided at x = 1 by a step, at x = 4 by the crease of planes 1 and 3 and at
// x = 5 by that of planes 0 and 3.
LabelledPlan strips(const std::vector<int>& labels) {
  const PlanPolygon outline = rectangle(0, 0, 6, 4);
  const std::vector<PlanLine> lines = {{Eigen::Vector2d::UnitX(), 1.0},
                                       {Eigen::Vector2d::UnitX(), 4.0, 1, 3},
                                       {Eigen::Vector2d::UnitX(), 5.0, 0, 3}};
  LabelledPlan plan{outline, lines, *PlanDivision::make(outline, lines), {}, 0.0};
  plan.labels.resize(plan.division.num_cells());
  const std::vector<double> middles = {0.5, 2.5, 4.5, 5.5};
  for (int i = 0; i < 4; ++i) plan.labels[plan.division.cell_at({middles[i], 2.0})] = labels[i];
  return plan;
}

PlaneChoice choice_of_four() {
  PlaneChoice choice;
  for (int i = 0; i < 4; ++i) {
    choice.add({0, 0, 3.0 + i}, 10 * i, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(i)});
  }
  return choice;
}

TEST(LabelledPlan, UsedPlanesKeepTheirOrderAndWhatBelongsToThem) {
  LabelledPlan plan = strips({3, 1, 3, 3});
  const PlaneChoice used = used_planes(choice_of_four(), &plan);
  EXPECT_EQ(used.origins, (std::vector<int>{10, 30}));
  ASSERT_EQ(used.planes.size(), 2u);
  EXPECT_EQ(used.planes[0].c, 4.0);
  EXPECT_EQ(used.planes[1].c, 6.0);
  ASSERT_EQ(used.reaches.size(), 2u);
  EXPECT_EQ(used.reaches[1].max().z(), 3.0);
  EXPECT_EQ(plan.labels[plan.division.cell_at({0.5, 2.0})], 1);
  EXPECT_EQ(plan.labels[plan.division.cell_at({2.5, 2.0})], 0);
}

TEST(LabelledPlan, CreasesOfPlanesThatNoCellUsesBecomeLinesOfSteps) {
  LabelledPlan plan = strips({3, 1, 3, 3});
  used_planes(choice_of_four(), &plan);
  EXPECT_FALSE(plan.lines[0].is_crease());
  EXPECT_EQ(plan.lines[1].a, 0);
  EXPECT_EQ(plan.lines[1].b, 1);
  EXPECT_FALSE(plan.lines[2].is_crease());
  EXPECT_EQ(plan.lines[2].b, -1);
}

TEST(LabelledPlan, CellsOfOnePlaneThatTouchMakeOneRegion) {
  const LabelledPlan plan = strips({1, 0, 0, 1});
  const PlaneChoice choice = choice_of_four();
  const auto roof = partition_of(plan, {choice.planes[0], choice.planes[1]});
  ASSERT_TRUE(roof);
  EXPECT_EQ(roof->regions.size(), 3u);
  EXPECT_EQ(roof_height(*roof, {0.5, 2.0}), 4.0);
  EXPECT_EQ(roof_height(*roof, {2.5, 2.0}), 3.0);
  EXPECT_EQ(roof_height(*roof, {4.5, 2.0}), 3.0);
  EXPECT_EQ(region_at(*roof, {2.5, 2.0}), region_at(*roof, {4.5, 2.0}));
  EXPECT_EQ(roof_height(*roof, {5.5, 2.0}), 4.0);
}

}  // namespace
}  // namespace gable
