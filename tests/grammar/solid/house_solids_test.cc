#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "grammar/solid/built_houses.h"

namespace gable {
namespace {

TEST(HouseSolids, GableHouseHasSevenFacesAndTenVertices) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofGable, {3.0, 2.0}));
  expect_counts(solid, 2, 4, 1, 10);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 1.0), 1e-6);
}

TEST(HouseSolids, FlatTopsOfTheCoarsestLevelStandAtTwoThirdsOfTheRise) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofGable, {3.0, 2.0}), Lod::k12);
  expect_counts(solid, 1, 4, 1, 8);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 4.0 / 3.0), 1e-6);
}

TEST(HouseSolids, HipHouseHasFourRoofFaces) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofHip, {3.0, 2.0, 0.2, 0.4}));
  expect_counts(solid, 4, 4, 1, 10);
  // A gable roof less a pyramid's share at each end: run * width * rise / 6.
  EXPECT_NEAR(volume(solid), 80.0 * 4.25 - (2.0 + 4.0) * 8.0 * 2.0 / 6.0, 1e-6);
}

TEST(HouseSolids, MansardHouseHasFourRoofFacesAndBrokenGables) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofMansard, {3.0, 4.0, 0.75, 0.25}));
  expect_counts(solid, 4, 4, 1, 14);
  // The mean height of a side: 1.5 over a quarter of it, 3.5 over the rest.
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 0.25 * 1.5 + 0.75 * 3.5), 1e-6);
}

TEST(HouseSolids, AMansardWhoseSidesAreNotBrokenIsAGable) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofMansard, {3.0, 2.0, 0.5, 0.5}));
  expect_counts(solid, 2, 4, 1, 10);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 1.0), 1e-6);
}

TEST(HouseSolids, HipsOfHalfTheLengthMakeAPyramid) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofHip, {3.0, 2.0, 0.5, 0.5}));
  expect_counts(solid, 4, 4, 1, 9);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 2.0 / 3.0), 1e-6);
}

TEST(HouseSolids, LHouseWithEqualRidgesHasCrossingValleysAndOneGroundFace) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {0, 0, 12, 6, 14, 6};
  for (Rule& roof : house.roofs) roof.values = {3.0, 2.0};
  // The ridges cross: each of the four slopes is cut in two by the valleys on the corner square's
  // diagonals, and both outer walls get a gable there.
  expect_counts(only_solid(house), 8, 6, 1, 6 + (6 + 2) + 5);
}

TEST(HouseSolids, LHouseIsOneFlatPrismAtTheCoarsestLevel) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {0, 0, 12, 6, 14, 6};
  for (Rule& roof : house.roofs) roof.values = {3.0, 1.5};
  const Solid solid = only_solid(house, Lod::k12);
  expect_counts(solid, 1, 6, 1, 12);
  EXPECT_NEAR(volume(solid), (12 * 6 + 8 * 6) * 4.25, 1e-6);
}

House two_flat_blocks(double x, double y, double height) {
  House house = make_house(Foundation::kII);
  house.footprints[0].values = {0, 0, 10, 8};
  house.footprints[1].values = {x, y, 4, 4};
  for (Rule& roof : house.roofs) roof = make_rule(RuleKind::kRoofFlat);
  house.roofs[0].values = {3.0};
  house.roofs[1].values = {height};
  return house;
}

TEST(HouseSolids, TouchingBlocksFormOneBody) {
  const Solid solid = only_solid(two_flat_blocks(7.0, 0.0, 5.0));
  // The higher block leaves two pieces of the lower one's wall, and has its own over the roof.
  expect_counts(solid, 2, 3 + 2 + 1 + 3, 1, 8 + 6 + 4);
  EXPECT_NEAR(volume(solid), 80 * 3.25 + 16 * 5.25, 1e-6);
}

TEST(HouseSolids, TowerInTheMiddleLeavesAHoleInTheRoof) {
  const Solid solid = only_solid(two_flat_blocks(1.0, 0.5, 5.0));
  expect_counts(solid, 2, 8, 1, 16);
  EXPECT_NEAR(volume(solid), 80 * 3.25 + 16 * 2, 1e-6);
  const auto holed = std::count_if(solid.faces.begin(), solid.faces.end(),
                                   [](const Face& f) { return f.rings.size() == 2; });
  EXPECT_EQ(holed, 1);
}

TEST(HouseSolids, CoveredBlockDoesNotShow) {
  expect_counts(only_solid(two_flat_blocks(1.0, 0.5, 2.0)), 1, 4, 1, 8);
}

TEST(HouseSolids, BlocksThatMeetInACornerOrNotAtAllAreTwoBodiesInOrder) {
  for (const double y : {6.0, 9.0}) {
    const HouseSolids solids = build(two_flat_blocks(7.0, y, 5.0), Lod::k22);
    ASSERT_EQ(solids.parts.size(), 2u);
    EXPECT_EQ(solids.parts[0].index, 0);
    EXPECT_EQ(solids.parts[1].index, 1);
    EXPECT_NEAR(volume(solids.parts[0].solid), 80 * 3.25, 1e-6);
    EXPECT_NEAR(volume(solids.parts[1].solid), 16 * 5.25, 1e-6);
  }
}

TEST(HouseSolids, NearlyEqualEdgesBecomeEqual) {
  for (const double miss : {1e-9, 1e-6, 1e-4, 1e-3, 5e-3, 1.5e-2}) {
    for (const double sign : {-1.0, 1.0}) {
      House house = two_flat_blocks(7.0 + sign * miss, 0.0, 3.0 + 0.4 * sign * miss);
      house.footprints[1].values[3] = 8.0 + sign * miss;
      expect_counts(only_solid(house), 1, 4, 1, 8);
    }
  }
}

TEST(HouseSolids, ParametersThatAreNotNumbersGiveAReason) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.roofs[0].values[0] = std::numeric_limits<double>::quiet_NaN();
  const HouseSolids solids = build(house, Lod::k22);
  EXPECT_TRUE(solids.parts.empty());
  EXPECT_EQ(solids.dropped.size(), 1u);
}

}  // namespace
}  // namespace gable
