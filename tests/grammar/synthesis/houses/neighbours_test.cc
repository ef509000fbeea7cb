#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/houses/neighbours.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

House random_placed(Random* random) {
  House house = random_house(random);
  house.origin = {400.0, 200.0, 70.0};
  return house;
}

/// Smallest distance of any part from the house's outline.
double distance_from(const House& house, const BuiltShape& shape) {
  double nearest = INFINITY;
  for (PlanPolygon& polygon : plan_outline(house)) {
    for (auto& p : polygon.outer) p += house.origin.head<2>();
    for (const BuiltPart& part : shape.parts) {
      nearest = std::min(nearest, ring_distance(polygon.outer, part.ring()));
    }
  }
  return nearest;
}

/// Share of points on the house that the other shape covers as well, a hand's breadth inside.
int common_points(const House& house, const BuiltShape& shape, Random* random) {
  const BuiltShape own = shape_of(house);
  int common = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p =
        house.origin.head<2>() +
        Eigen::Vector2d(random->uniform(-18.0, 18.0), random->uniform(-18.0, 18.0));
    common += std::isfinite(own.at(p)) && std::isfinite(shape.at(p));
  }
  return common;
}

TEST(Neighbours, PartyWallsTouchAndDoNotOverlap) {
  Random random(1);
  int made = 0;
  for (int i = 0; i < 200; ++i) {
    const House house = random_placed(&random);
    const BuiltShape shape = random_neighbours(NeighbourKind::kPartyWall, house, &random);
    if (shape.parts.empty()) continue;
    ++made;
    EXPECT_LT(distance_from(house, shape), 1e-6) << i;
    EXPECT_EQ(common_points(house, shape, &random), 0) << i;
  }
  EXPECT_GT(made, 180);
}

TEST(Neighbours, CloseOnesLeaveAGapOfUpToThreeMetres) {
  Random random(2);
  int made = 0;
  for (int i = 0; i < 200; ++i) {
    const House house = random_placed(&random);
    const BuiltShape shape = random_neighbours(NeighbourKind::kClose, house, &random);
    if (shape.parts.empty()) continue;
    ++made;
    EXPECT_GE(distance_from(house, shape), 0.4 - 1e-6) << i;
    EXPECT_LE(distance_from(house, shape), 3.0 + 1e-6) << i;
  }
  EXPECT_GT(made, 180);
}

TEST(Neighbours, OthersStandThreeMetresApartOrMore) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const House house = random_placed(&random);
    const BuiltShape shape = random_neighbours(NeighbourKind::kApart, house, &random);
    ASSERT_FALSE(shape.parts.empty());
    EXPECT_GE(distance_from(house, shape), 3.0 - 0.01) << i;
    EXPECT_LE(distance_from(house, shape), 9.0) << i;
  }
}

TEST(Neighbours, OfAnyOutlineTouchOrKeepTheirGap) {
  Random random(4);
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {12, 1}, {10, 9}, {4, 6}, {-2, 8}};
  int made = 0;
  for (int i = 0; i < 100; ++i) {
    const auto party = random_neighbours(NeighbourKind::kPartyWall, outline, 5.0, &random);
    const auto close = random_neighbours(NeighbourKind::kClose, outline, 5.0, &random);
    if (party.parts.empty() || close.parts.empty()) continue;
    ++made;
    EXPECT_LT(ring_distance(outline, party.parts[0].ring()), 0.01);
    EXPECT_GE(ring_distance(outline, close.parts[0].ring()), 0.05);
    EXPECT_GE(party.parts[0].eaves, 5.0 + 2.4);
  }
  EXPECT_GT(made, 80);
}

}  // namespace
}  // namespace gable
