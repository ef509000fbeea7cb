#include <gtest/gtest.h>

#include "grammar/solid/built_houses.h"

namespace gable {
namespace {

Rule chimney_at(double x, double y, double side, double height) {
  Rule rule = make_rule(RuleKind::kChimney);
  rule.values = {x, y, side, height};
  return rule;
}

Rule dormer_at(double x, double y, double width, double depth, double eaves, double rise) {
  Rule rule = make_rule(RuleKind::kDormer);
  rule.values = {x, y, width, depth, eaves, rise};
  rule.component = 0;
  return rule;
}

Rule garage_at(double x, double y, double length, double width, double height) {
  Rule rule = make_rule(RuleKind::kGarageI);
  rule.values = {x, y, length, width, height};
  return rule;
}

TEST(HouseSolids, ChimneyOnTheRidgeStandsOnBothSlopes) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(1.0, 2.0, 1.0, 6.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kChimney);
  expect_counts(solids.parts[1].solid, 1, 4, 2, 10);
  EXPECT_NEAR(volume(solids.parts[1].solid), 1.0 + 0.5 * 0.25, 1e-6);
}

TEST(HouseSolids, ChimneyAtTheGableStandsOnTheGroundOutside) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(6.0, 2.0, 1.0, 6.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_NEAR(volume(solids.parts[1].solid), 0.5 * 6.25 + 0.5 * (1.0 + 0.125), 1e-6);
}

TEST(HouseSolids, ChimneyInsideTheAtticIsDropped) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(1.0, 2.0, 1.0, 4.0));
  const HouseSolids solids = build(house, Lod::k22);
  EXPECT_EQ(solids.parts.size(), 1u);
  ASSERT_EQ(solids.dropped.size(), 1u);
  EXPECT_EQ(solids.dropped[0], "chimney 1: nothing shows above what stands below");
}

TEST(HouseSolids, DormerRunsIntoTheSlope) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.dormers.push_back(dormer_at(1.0, 4.5, 2.0, 2.5, 4.2, 0.1));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kDormer);
  // Two roofs, a gable with its two cheeks, and the slope below.
  expect_counts(solids.parts[1].solid, 2, 3, 1, 8);
}

TEST(HouseSolids, DormerOverTheEavesEndsAtTheWall) {
  House house = one_block(RuleKind::kRoofFlat, {3.0});
  house.dormers.push_back(dormer_at(1.0, 6.0, 2.0, 2.0, 4.0, 0.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_NEAR(volume(solids.parts[1].solid), 2.0 * 1.0 * 1.0, 1e-6);
}

TEST(HouseSolids, GarageIsCutByTheHouse) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(6.0, 2.0, 4.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k20);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kGarage);
  expect_counts(solids.parts[1].solid, 1, 4, 1, 8);
  EXPECT_NEAR(volume(solids.parts[1].solid), 2.0 * 3.0 * 2.75, 1e-6);
}

TEST(HouseSolids, GarageUnderTheRoofIsDropped) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(1.0, 2.0, 4.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k12);
  EXPECT_EQ(solids.parts.size(), 1u);
  EXPECT_EQ(solids.dropped.size(), 1u);
}

TEST(HouseSolids, GarageAcrossTheHouseFallsInTwo) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(1.0, 2.0, 20.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k20);
  ASSERT_EQ(solids.parts.size(), 3u);
  EXPECT_EQ(solids.parts[1].index, 0);
  EXPECT_EQ(solids.parts[2].index, 0);
  EXPECT_NEAR(total_volume(solids), 80 * 4.25 + 10 * 3 * 2.75, 1e-6);
}

}  // namespace
}  // namespace gable
