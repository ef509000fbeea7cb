#include <gable/engine/solver/house_refinement.h>
#include <gtest/gtest.h>

#include <cmath>

#include "residuals/house_gradient_error.h"

namespace gable {
namespace {

// A hipped and a gabled block, seen with noise, outliers and a hole.
House two_blocks() {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = 0.35;
  house.footprints[0].values = {-1.0, -1.0, 11.0, 8.0};
  house.footprints[1].values = {2.0, 3.5, 6.0, 8.0};
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0].values = {5.5, 3.0, 0.3, 0.25};
  house.roofs[1].values = {4.8, 2.6};
  house.roofs[1].ridge = Axis::kY;
  return house;
}

HeightImage image_of(const House& house) {
  HeightImage image;
  image.rows = 48;
  image.cols = 48;
  image.gsd = 0.5;
  image.first_center = {-11.75, 11.75};
  image.ground.assign(image.size(), 0.0f);
  image.weight.assign(image.size(), 1.0f);
  const HeightField field(house);
  Random random(9);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      double height = field.at_local(image.center_of(row, col), 0.5, 0.0);
      if (random.chance(0.7)) height += random.uniform(-0.3, 0.3);
      if (random.chance(0.03)) height = random.uniform(0.0, 12.0);
      image.height.push_back(static_cast<float>(height));
      if (row < 5 && col < 9) image.weight[image.height.size() - 1] = 0.0f;
    }
  }
  return image;
}

House start_of(const House& truth) {
  House house = truth;
  house.azimuth[0] += 0.05;
  house.footprints[0].values = {-0.2, -1.8, 10.0, 8.8};
  house.footprints[1].values = {2.8, 2.7, 6.6, 7.2};
  house.roofs[0].values = {6.0, 2.5, 0.2, 0.35};
  house.roofs[1].values = {4.3, 3.1};
  return house;
}

TEST(Gradient, HouseHeightCostAlongTheIteratesOfAFit) {
  const House truth = two_blocks();
  const HeightImage image = image_of(truth);
  House house = start_of(truth);
  for (const RefinementStage& stage : RefinementOptions{}.stages) {
    for (int step = 0; step < 6; ++step) {
      HeightImage smooth = image;
      const double kept = keep_smooth_pixels(house, stage.support, &smooth);
      EXPECT_GT(kept, 0.9);
      const HeightCostOptions options{stage.support, stage.loss, stage.loss_scale, 1};
      EXPECT_LT(house_gradient_error(house, smooth, options), 1e-6)
          << "support " << stage.support << ", step " << step;
      RefinementOptions one;
      one.stages = {stage};
      one.stages[0].max_iterations = 1;
      one.deviations = false;
      refine_house(image, one, &house);
    }
  }
}

TEST(HousePriors, AStrongPriorHoldsItsParameterAndAWeakOneDoesNot) {
  const House truth = two_blocks();
  const HeightImage image = image_of(truth);
  RefinementOptions options;
  House free = start_of(truth);
  refine_house(image, options, &free);
  EXPECT_NEAR(free.roofs[0][param::roof::kEaves], 5.5, 0.1);

  House held = start_of(truth);
  options.priors = {{held.roof_block(0), param::roof::kEaves, 6.0, 1e-4}};
  refine_house(image, options, &held);
  EXPECT_NEAR(held.roofs[0][param::roof::kEaves], 6.0, 0.01);

  House weak = start_of(truth);
  options.priors[0].deviation = 10.0;
  refine_house(image, options, &weak);
  EXPECT_NEAR(weak.roofs[0][param::roof::kEaves], free.roofs[0][param::roof::kEaves], 0.02);
}

TEST(HousePriors, APriorDecidesWhatNoPixelSees) {
  const House truth = two_blocks();
  HeightImage image = image_of(truth);
  House house = truth;
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {100.0, 100.0, 0.7, 5.0};  // outside the image
  house.chimneys.push_back(chimney);
  RefinementOptions options;
  options.priors = {{house.chimney_block(0), param::chimney::kHeight, 7.0, 0.5}};
  const RefinementSummary summary = refine_house(image, options, &house);
  EXPECT_NEAR(house.chimneys[0][param::chimney::kHeight], 7.0, 0.05);
  EXPECT_TRUE(std::isfinite(summary.deviations[house.chimney_block(0)][param::chimney::kHeight]));
  EXPECT_TRUE(std::isinf(summary.deviations[house.chimney_block(0)][param::chimney::kSide]));
}

TEST(HousePriors, AResidualOfOnesOwnCountsLikeOneOfTheLibrary) {
  const House truth = two_blocks();
  const HeightImage image = image_of(truth);
  RefinementOptions with_prior, with_own;
  with_prior.priors = {{truth.roof_block(0), param::roof::kEaves, 6.0, 0.01}};
  with_own.add_residuals = [&](const House& house, std::span<double* const> blocks,
                               ceres::Problem* problem) {
    ASSERT_EQ(blocks.size(), house.derivation().size());
    HouseRelation own = parameter_priors(house, with_prior.priors, with_own.height_deviation);
    problem->AddResidualBlock(own.cost.release(), nullptr, blocks[own.rules[0]]);
  };
  House a = start_of(truth), b = start_of(truth);
  const RefinementSummary prior = refine_house(image, with_prior, &a);
  const RefinementSummary own = refine_house(image, with_own, &b);
  EXPECT_EQ(prior.final_cost, own.final_cost);
  EXPECT_EQ(prior.deviations, own.deviations);
  for (size_t i = 0; i < a.derivation().size(); ++i) {
    EXPECT_EQ(a.derivation()[i]->values, b.derivation()[i]->values);
  }
  EXPECT_NEAR(b.roofs[0][param::roof::kEaves], 6.0, 0.05);
}

TEST(HousePriors, CheckNamesTheViolatedBound) {
  RefinementOptions options;
  EXPECT_EQ(check(options), "");
  options.priors = {{1, 0, 0.0, 0.0}};
  EXPECT_EQ(check(options), "a prior's deviation must be above 0");
  options = {};
  options.height_deviation = 0.0;
  EXPECT_EQ(check(options), "height_deviation must lie in (0, 100]");
}

}  // namespace
}  // namespace gable
