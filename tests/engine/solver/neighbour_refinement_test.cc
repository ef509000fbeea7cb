#include <gable/engine/solver/neighbour_refinement.h>
#include <gable/grammar/block.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/row_of_houses.h"

namespace gable {
namespace {

using Kind = NeighbourRelationKind;

struct Row {
  std::vector<House> houses;
  std::vector<HeightImage> images;

  std::vector<NeighbourHouse> neighbours() {
    std::vector<NeighbourHouse> out;
    for (size_t i = 0; i < houses.size(); ++i) out.push_back({&images[i], &houses[i]});
    return out;
  }
  std::vector<const House*> views() const {
    std::vector<const House*> out;
    for (const House& house : houses) out.push_back(&house);
    return out;
  }
};

// Houses as each was fitted by itself.
Row fitted_row(int count, const ViewOptions& view) {
  Row row;
  row.houses = row_of_houses(count);
  row.images = images_of(row.houses, view);
  RefinementOptions options;
  options.deviations = false;
  for (size_t i = 0; i < row.houses.size(); ++i) {
    refine_house(row.images[i], options, &row.houses[i]);
  }
  return row;
}

double worst(const Row& row, const std::vector<NeighbourRelation>& relations, Kind kind) {
  double most = 0.0;
  for (const NeighbourRelation& relation : relations) {
    if (relation.kind == kind) most = std::max(most, misfit(row.views(), relation));
  }
  return most;
}

// Two flat boxes whose images lie wholly inside them, so that heights decide the eaves alone.
Row two_flats(double height_a, double height_b) {
  Row row;
  row.houses = row_of_houses(2, 0.0);
  for (size_t i = 0; i < 2; ++i) {
    House& house = row.houses[i];
    house.origin.z() = 0.0;
    house.roofs[0] = make_rule(RuleKind::kRoofFlat);
    house.roofs[0][param::roof::kEaves] = i == 0 ? height_a : height_b;
    ViewOptions view;
    view.size = i == 0 ? 8 : 4;
    row.images.push_back(image_of(house, view));
  }
  return row;
}

TEST(NeighbourRefinement, EqualEavesAreTheWeightedMeanInClosedForm) {
  Row row = two_flats(5.0, 5.1);
  NeighbourRefinementOptions options;
  options.stage = {0.25, LossKind::kSoftL1, 100.0, 1, 50};
  options.relations.height = {0.3, 0.1, 10.0};
  options.function_tolerance = 1e-14;
  const std::vector<NeighbourRelation> relations = {{Kind::kEqualEaves, 0, 1, {}, {}}};
  const NeighbourRefinementSummary summary =
      refine_neighbours(row.neighbours(), relations, options);
  EXPECT_EQ(summary.minimizer.termination, Termination::kConverged);
  // 64 and 16 pixels, and a spring of (0.2 / 0.1)^2 between them.
  const double spring = 4.0, stiffness = 1.0 / (1.0 / 64.0 + 1.0 / 16.0 + 1.0 / spring);
  const double force = stiffness * 0.1;
  EXPECT_NEAR(row.houses[0].roofs[0][0], 5.0 + force / 64.0, 1e-5);
  EXPECT_NEAR(row.houses[1].roofs[0][0], 5.1 - force / 16.0, 1e-5);
  EXPECT_NEAR(summary.misfits[0], force / spring, 1e-5);
}

TEST(NeighbourRefinement, ARelationLetsGoWhereHeightsDisagree) {
  Row row = two_flats(5.0, 5.12);
  const std::vector<NeighbourRelation> relations =
      detect_neighbour_relations(row.views(), NeighbourRelationOptions{});
  ASSERT_EQ(relations[1].kind, Kind::kEqualEaves);
  NeighbourRefinementOptions options;
  options.relations.height.let_go = 0.005;
  refine_neighbours(row.neighbours(), relations, options);
  EXPECT_NEAR(row.houses[0].roofs[0][0], 5.0, 0.01);
  EXPECT_NEAR(row.houses[1].roofs[0][0], 5.12, 0.03);
}

TEST(NeighbourRefinement, WallsOfExactHousesBecomeOneWhereTheyAre) {
  Row row = fitted_row(4, {.gsd = 0.5, .size = 40});
  const auto relations = detect_neighbour_relations(row.views(), NeighbourRelationOptions{});
  EXPECT_GT(worst(row, relations, Kind::kPartyWall), 0.03);
  refine_neighbours(row.neighbours(), relations, {});
  EXPECT_LT(worst(row, relations, Kind::kPartyWall), 0.02);
  EXPECT_LT(worst(row, relations, Kind::kEqualEaves), 0.005);
  const std::vector<House> truth = row_of_houses(4);
  for (size_t i = 0; i + 1 < truth.size(); ++i) {
    for (const NeighbourRelation& relation : relations) {
      if (relation.kind != Kind::kPartyWall || relation.house_a != static_cast<int>(i)) continue;
      const WallContact contact =
          wall_contact(row.houses[i], relation.wall_a, truth[i + 1], relation.wall_b);
      EXPECT_NEAR(contact.offset_from, 0.0, 0.12);
      EXPECT_NEAR(contact.offset_to, 0.0, 0.12);
    }
  }
}

TEST(NeighbourRefinement, ABiasedImageIsCorrectedByTheNeighbours) {
  // The eaves of the middle house are hidden but for a few pixels, which are 0.15 m too high.
  const std::vector<House> truth = row_of_houses(3);
  Row row = fitted_row(3, {.gsd = 0.5, .size = 40});
  HeightImage& image = row.images[1];
  for (size_t i = 0; i < image.size(); ++i) {
    if (!image.inside[i]) continue;
    image.height[i] += 0.15f;
    if (i % 7 != 0) image.weight[i] = 0.0f;
  }
  RefinementOptions single;
  single.deviations = false;
  refine_house(image, single, &row.houses[1]);
  const double truth_eaves = truth[1].roofs[0][param::roof::kEaves];
  const double alone = row.houses[1].roofs[0][param::roof::kEaves] - truth_eaves;
  NeighbourRelationOptions wide;
  wide.height.tolerance = 0.3;
  const auto relations = detect_neighbour_relations(row.views(), wide);
  NeighbourRefinementOptions options;
  options.relations.height.let_go = 0.3;
  refine_neighbours(row.neighbours(), relations, options);
  const double together = row.houses[1].roofs[0][param::roof::kEaves] - truth_eaves;
  EXPECT_GT(alone, 0.1);
  EXPECT_LT(std::abs(together), 0.7 * alone);
}

TEST(NeighbourRefinement, SparseAndDenseEliminationAgree) {
  const Row start = fitted_row(6, {.gsd = 0.5, .size = 32, .noise = 0.1});
  const auto relations = detect_neighbour_relations(start.views(), NeighbourRelationOptions{});
  std::vector<Row> rows(2, start);
  NeighbourRefinementOptions options;
  for (bool sparse : {false, true}) {
    options.sparse = sparse;
    refine_neighbours(rows[sparse].neighbours(), relations, options);
  }
  for (size_t i = 0; i < start.houses.size(); ++i) {
    const auto a = rows[0].houses[i].derivation(), b = rows[1].houses[i].derivation();
    for (size_t r = 0; r < a.size(); ++r) {
      for (int k = 0; k < a[r]->size(); ++k) EXPECT_NEAR((*a[r])[k], (*b[r])[k], 1e-6);
    }
  }
}

TEST(NeighbourRefinement, WithoutRelationsHousesAreRefinedAsIfAlone) {
  Row row = fitted_row(2, {.gsd = 0.5, .size = 32, .noise = 0.1});
  std::vector<House> alone = row.houses;
  NeighbourRefinementOptions options;
  options.function_tolerance = 0.0;
  options.stage.max_iterations = 60;
  refine_neighbours(row.neighbours(), {}, options);
  RefinementOptions single;
  single.stages = {options.stage};
  single.function_tolerance = 0.0;
  for (size_t i = 0; i < alone.size(); ++i) {
    const RefinementSummary summary = refine_house(row.images[i], single, &alone[i]);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(alone[i].footprints[0][k], row.houses[i].footprints[0][k], 2e-3);
    }
    EXPECT_EQ(deviations_from_heights(row.images[i], options.stage, alone[i]), summary.deviations);
  }
}

TEST(NeighbourRefinement, CheckNamesTheViolatedBound) {
  NeighbourRefinementOptions options;
  EXPECT_EQ(check(options), "");
  options.stage.support = 0.0;
  EXPECT_EQ(check(options), "support must lie in (0, 100]");
  options = {};
  options.relations.wall.deviation = -1.0;
  EXPECT_EQ(check(options), "wall.deviation must lie in (0, 10]");
}

}  // namespace
}  // namespace gable
