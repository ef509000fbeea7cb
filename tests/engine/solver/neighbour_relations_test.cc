#include <gable/engine/solver/neighbour_relations.h>
#include <gable/grammar/block.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/row_of_houses.h"

namespace gable {
namespace {

using Kind = NeighbourRelationKind;

std::vector<const House*> views(const std::vector<House>& houses) {
  std::vector<const House*> out;
  for (const House& house : houses) out.push_back(&house);
  return out;
}

std::vector<NeighbourRelation> detect(const std::vector<House>& houses) {
  return detect_neighbour_relations(views(houses), {});
}

int count(const std::vector<NeighbourRelation>& relations, Kind kind) {
  return static_cast<int>(std::count_if(relations.begin(), relations.end(),
                                        [&](const auto& r) { return r.kind == kind; }));
}

TEST(NeighbourRelations, HousesOfARowShareAllTheyHave) {
  const std::vector<House> houses = row_of_houses(7);
  const std::vector<NeighbourRelation> relations = detect(houses);
  for (Kind kind :
       {Kind::kPartyWall, Kind::kEqualEaves, Kind::kEqualRidges, Kind::kEqualAzimuths}) {
    EXPECT_EQ(count(relations, kind), 6);
  }
  for (const NeighbourRelation& relation : relations) {
    EXPECT_EQ(relation.house_b, relation.house_a + 1);
    EXPECT_NEAR(misfit(views(houses), relation), 0.0, 1e-9);
  }
}

TEST(NeighbourRelations, WhatDiffersIsNotShared) {
  std::vector<House> houses = row_of_houses(2);
  houses[1].roofs[0][param::roof::kEaves] -= 0.4;
  houses[1].roofs[0][param::roof::kRise] += 0.4;
  std::vector<NeighbourRelation> relations = detect(houses);
  EXPECT_EQ(count(relations, Kind::kEqualEaves), 0);
  EXPECT_EQ(count(relations, Kind::kEqualRidges), 1);
  houses[1].azimuth[0] += 5.0 * M_PI / 180.0;
  relations = detect(houses);
  EXPECT_EQ(count(relations, Kind::kPartyWall), 1);
  EXPECT_EQ(count(relations, Kind::kEqualAzimuths), 0);
  houses[1].roofs[0] = make_rule(RuleKind::kRoofFlat);
  houses[1].roofs[0][param::roof::kEaves] = 7.9;
  EXPECT_EQ(count(detect(houses), Kind::kEqualRidges), 0);
}

TEST(NeighbourRelations, WallsApartOrBesideEachOtherByLittleAreNone) {
  std::vector<House> houses = row_of_houses(2, 0.0);
  houses[1].origin.x() += 0.55;
  EXPECT_EQ(count(detect(houses), Kind::kPartyWall), 1);
  houses[1].origin.x() += 0.1;
  EXPECT_TRUE(detect(houses).empty());
  houses[1].origin.x() -= 0.65;
  houses[1].origin.y() += 7.4;  // 1.6 m of 9 are left
  EXPECT_EQ(count(detect(houses), Kind::kPartyWall), 1);
  houses[1].origin.y() += 0.2;
  EXPECT_TRUE(detect(houses).empty());
}

TEST(NeighbourRelations, CheckNamesTheViolatedBound) {
  NeighbourRelationOptions options;
  EXPECT_EQ(check(options), "");
  options.height.let_go = 0.0;
  EXPECT_EQ(check(options), "height.let_go must lie in (0, 10]");
  options = {};
  options.least_contact = 0.0;
  EXPECT_EQ(check(options), "least_contact must lie in (0, 100]");
}

}  // namespace
}  // namespace gable
