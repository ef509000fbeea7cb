#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/neighbours/join_neighbours.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/row_of_houses.h"

namespace gable {
namespace {

using ::testing::Contains;
using ::testing::Field;

struct Window {
  std::vector<Building> buildings;
  std::vector<HeightImage> images;

  std::vector<FittedBuilding> fitted() const {
    std::vector<FittedBuilding> out;
    for (size_t i = 0; i < buildings.size(); ++i) out.push_back({&buildings[i], &images[i]});
    return out;
  }
};

// A row whose houses were fitted one by one, with an extrusion at its end.
Window fitted_row(int count) {
  Window window;
  std::vector<House> houses = row_of_houses(count);
  window.images = images_of(houses, {.gsd = 0.5, .size = 40, .noise = 0.1});
  RefinementOptions options;
  options.stages = {last_stage(true)};
  for (int i = 0; i < count; ++i) {
    Building building;
    building.id = "h" + std::to_string(i);
    refine_house(window.images[i], options, &houses[i]);
    building.house = houses[i];
    set_fit(fit_of_building(window.images[i], building), &building);
    window.buildings.push_back(building);
  }
  Building extrusion;
  extrusion.id = "shed";
  extrusion.status = BuildingStatus::kExtrusion;
  extrusion.origin = window.images.back().origin;
  extrusion.outline = {{{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {}};
  extrusion.height = 3.0;
  window.buildings.push_back(extrusion);
  window.images.push_back(window.images.back());
  return window;
}

JoinOptions options_for_outlines() {
  JoinOptions options;
  options.refinement.stage = last_stage(true);
  return options;
}

TEST(JoinNeighbours, WallsComeTogetherAndNoHouseIsMuchFurtherFromItsHeights) {
  const Window window = fitted_row(4);
  const auto joined = join_neighbours(window.fitted(), options_for_outlines(), 1, {});
  ASSERT_EQ(joined.size(), 5u);
  EXPECT_FALSE(joined[4].has_value());
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(joined[i].has_value()) << i;
    EXPECT_EQ(joined[i]->building.id, window.buildings[i].id);
    EXPECT_EQ(joined[i]->building.house->origin, window.images[i].origin);
    EXPECT_LT(joined[i]->building.quality.mad, window.buildings[i].quality.mad + 0.02);
    EXPECT_EQ(joined[i]->building.deviations.size(), 3u);
    EXPECT_FALSE(joined[i]->model.parts.empty());
    double before = 0.0, after = 0.0;
    for (const UsedRelation& relation : joined[i]->relations) {
      if (relation.kind != NeighbourRelationKind::kPartyWall) continue;
      before = std::max(before, relation.before);
      after = std::max(after, relation.after);
    }
    EXPECT_LT(after, 0.03);
    EXPECT_GT(before, after);
  }
  EXPECT_THAT(joined[0]->relations, Contains(Field(&UsedRelation::neighbour, "h1")));
  EXPECT_THAT(joined[1]->relations, Contains(Field(&UsedRelation::neighbour, "h0")));
  EXPECT_THAT(joined[1]->relations, Contains(Field(&UsedRelation::neighbour, "h2")));
}

TEST(JoinNeighbours, ThreadsAndCutsOfGroupsAreRepeatable) {
  const Window window = fitted_row(5);
  JoinOptions options = options_for_outlines();
  options.most_houses = 2;
  const auto one = join_neighbours(window.fitted(), options, 1, {});
  const auto three = join_neighbours(window.fitted(), options, 3, {});
  EXPECT_FALSE(one[4].has_value());  // the fifth has no partner in its group
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(one[i] && three[i]);
    const auto a = std::as_const(*one[i]->building.house).derivation();
    const auto b = std::as_const(*three[i]->building.house).derivation();
    for (size_t r = 0; r < a.size(); ++r) EXPECT_EQ(a[r]->values, b[r]->values);
  }
}

TEST(JoinNeighbours, AHouseThatWouldLoseItsHeightsKeepsItsWallsAlone) {
  Window window = fitted_row(4);
  // The last house's eaves are known to be 0.25 m higher; nothing lets go here.
  for (float& z : window.images[3].height) z += z > 2.0f ? 0.25f : 0.0f;
  RefinementOptions single;
  single.stages = {last_stage(true)};
  refine_house(window.images[3], single, &*window.buildings[3].house);
  JoinOptions options = options_for_outlines();
  options.refinement.relations.height = {0.3, 0.01, 10.0};
  const auto joined = join_neighbours(window.fitted(), options, 1, {});
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(joined[i].has_value());
    int heights = 0;
    for (const UsedRelation& relation : joined[i]->relations) {
      const bool wall = relation.kind == NeighbourRelationKind::kPartyWall;
      EXPECT_TRUE(i != 3 || wall);
      heights += relation.kind == NeighbourRelationKind::kEqualEaves;
    }
    EXPECT_TRUE(i != 0 || heights == 1);
  }
}

TEST(JoinNeighbours, WhereNothingMayBeLostNothingIsJoined) {
  const Window window = fitted_row(3);
  JoinOptions options = options_for_outlines();
  options.cost_rise = 0.0;
  options.rounds = 1;
  options.refinement.relations.height = {0.3, 0.0001, 10.0};
  for (const auto& joined : join_neighbours(window.fitted(), options, 1, {})) {
    EXPECT_FALSE(joined.has_value());
  }
}

TEST(JoinNeighbours, AStopRequestLeavesHousesAsTheyWere) {
  std::stop_source stop;
  stop.request_stop();
  const Window window = fitted_row(2);
  for (const auto& joined :
       join_neighbours(window.fitted(), options_for_outlines(), 1, stop.get_token())) {
    EXPECT_FALSE(joined.has_value());
  }
}

TEST(JoinNeighbours, CheckNamesTheViolatedBound) {
  JoinOptions options;
  EXPECT_EQ(check(options), "");
  options.most_houses = 1;
  EXPECT_EQ(check(options), "most_houses must lie in [2, 1000]");
  options = {};
  options.cost_rise = -0.1;
  EXPECT_EQ(check(options), "cost_rise must lie in [0, 1]");
}

}  // namespace
}  // namespace gable
