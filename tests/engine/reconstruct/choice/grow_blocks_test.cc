#include <gable/engine/reconstruct/choice/grow_blocks.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gtest/gtest.h>

#include <cstring>

#include "engine/house_image.h"
#include "engine/reconstruct/many_block_shapes.h"

namespace gable {
namespace {

constexpr double kNoise = 0.1;

GrowthOptions options() {
  GrowthOptions out;
  out.penalty = {0.25, LossKind::kGemanMcClure, 2.6 * kNoise, kNoise, {}};
  out.detail_penalty = out.penalty;
  return out;
}

HeightImage image_with_noise(const House& house) {
  return image_of(house, {.size = 72, .noise = kNoise, .outliers = 0.01, .seed = 3});
}

TEST(GrowBlocks, AHouseGrowsFromOneBlockToAllOfThem) {
  for (const ManyBlockShape& shape : many_block_shapes()) {
    const HeightImage image = image_with_noise(shape.house);
    House house = blocks_house({roofed_rectangles(shape.house)[0]}, shape.house.azimuth[0]);
    PenalisedCost cost = penalised_cost(image, house, options().penalty);
    const double before = cost.total;
    ASSERT_TRUE(grow_blocks(image, options(), &house, &cost)) << shape.name;
    EXPECT_TRUE(is_well_formed(house));
    EXPECT_LT(cost.total, before);
    EXPECT_EQ(cost.total, penalised_cost(image, house, options().penalty).total);
    EXPECT_LT(mean_difference(house, shape.house), 0.15) << shape.name;
    EXPECT_LE(house.num_components(), shape.house.num_components()) << shape.name;
  }
}

TEST(GrowBlocks, APerfectHouseStaysAsItIs) {
  for (const ManyBlockShape& shape : many_block_shapes()) {
    const HeightImage image = image_with_noise(shape.house);
    House house = shape.house;
    PenalisedCost cost = penalised_cost(image, house, options().penalty);
    EXPECT_FALSE(grow_blocks(image, options(), &house, &cost)) << shape.name;
    EXPECT_EQ(house.num_components(), shape.house.num_components());
    EXPECT_EQ(surface_difference(house, shape.house, 15.0, 1), 0.0);
  }
}

TEST(GrowBlocks, KeepsToTheMostBlocksAllowed) {
  const House truth = terrace_shape();
  const HeightImage image = image_with_noise(truth);
  GrowthOptions few = options();
  few.most_blocks = 3;
  House house = blocks_house({roofed_rectangles(truth)[0]}, truth.azimuth[0]);
  PenalisedCost cost = penalised_cost(image, house, few.penalty);
  grow_blocks(image, few, &house, &cost);
  EXPECT_LE(house.num_components(), 3);
}

TEST(GrowBlocks, WhatTheDetectorsRuleOutMustSaveItsCharge) {
  const House truth = terrace_shape();
  const HeightImage image = image_with_noise(truth);
  GrowthOptions charged = options();
  charged.penalty.foundation_charge[static_cast<size_t>(Foundation::kMany)] = 1e6;
  House house = blocks_house({roofed_rectangles(truth)[0]}, truth.azimuth[0]);
  PenalisedCost cost = penalised_cost(image, house, charged.penalty);
  grow_blocks(image, charged, &house, &cost);
  EXPECT_NE(house.foundation, Foundation::kMany);
}

TEST(GrowBlocks, DetailsStayWhereTheyAre) {
  House truth = t_shape();
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {-6.0, 4.4, 1.0, 9.5};
  truth.chimneys = {chimney};
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.component = 0;
  dormer.values = {6.0, 1.8, 2.6, 2.8, 6.6, 0.7};
  truth.dormers = {dormer};
  const HeightImage image = image_with_noise(truth);
  House house = blocks_house({roofed_rectangles(truth)[0]}, truth.azimuth[0]);
  house.chimneys = truth.chimneys;
  house.dormers = truth.dormers;
  PenalisedCost cost = penalised_cost(image, house, options().penalty);
  ASSERT_TRUE(grow_blocks(image, options(), &house, &cost));
  ASSERT_EQ(house.chimneys.size(), 1u);
  ASSERT_EQ(house.dormers.size(), 1u);
  EXPECT_NEAR(house.chimneys[0][0], -6.0, 0.3);
  EXPECT_EQ(house.dormers[0].component, 0);
}

TEST(GrowBlocks, OptionsOutOfRangeAreNamed) {
  GrowthOptions bad = options();
  bad.most_blocks = 0;
  EXPECT_EQ(check(bad), "most_blocks must lie in [1, 20]");
  bad = options();
  bad.least_area = 0.0;
  EXPECT_EQ(check(bad), "least_area must be positive");
}

TEST(HouseChoice, FindsShapesOfManyBlocks) {
  for (const ManyBlockShape& shape : many_block_shapes()) {
    const HeightImage image = image_with_noise(shape.house);
    for (const bool known : {false, true}) {
      HouseChoiceOptions choice_options;
      choice_options.outline_known = known;
      const HouseChoice choice = choose_house(image, choice_options);
      ASSERT_TRUE(choice.found);
      EXPECT_LT(mean_difference(choice.best.house, shape.house), 0.15) << shape.name << known;
      EXPECT_LE(choice.best.house.num_components(), shape.house.num_components())
          << shape.name << known;
    }
  }
}

}  // namespace
}  // namespace gable
