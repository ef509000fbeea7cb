#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/residuals/house_height_cost.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"
#include "residuals/random_houses.h"

namespace gable {
namespace {

// S as the refinement's evaluator sees it.
double evaluated_residuals(const HeightImage& image, const House& house, const PenaltyOptions& o) {
  const HouseHeightEvaluator evaluator(house, &image, {o.support, o.loss, o.loss_scale, 1});
  return evaluator.squared_residuals(pointers(house).data());
}

int inside_evidence(const HeightImage& image) {
  int n = 0;
  for (size_t i = 0; i < image.size(); ++i) n += image.inside[i] && image.weight[i] >= 0.5f;
  return n;
}

House detailed_house() {
  House house = box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3);
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {3.0, 0.0, 1.0, 9.0};
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.component = 0;
  dormer.values = {-2.0, -2.5, 2.4, 2.4, 6.6, 0.6};
  Rule garage = make_rule(RuleKind::kGarageI);
  garage.values = {8.0, 0.0, 4.0, 5.0, 2.6};
  house.chimneys = {chimney};
  house.dormers = {dormer};
  house.garages = {garage};
  return house;
}

TEST(PenalisedCost, IsResidualsOverVariancePlusThePriceOfItsParameters) {
  const House house = detailed_house();
  HeightImage image = image_of(house, {.noise = 0.1});
  for (int i = 0; i < 40; ++i) image.weight[image.index(31, 12 + i)] = 0.05f;  // no evidence
  PenaltyOptions options;
  options.noise = 0.2;
  const PenalisedCost cost = penalised_cost(image, house, options);
  // Azimuth 1, rectangle 4, gable 2, dormer 5 of 6, chimney 3 of 4, garage 5.
  EXPECT_EQ(cost.num_parameters, 20);
  EXPECT_EQ(cost.num_samples, inside_evidence(image));
  EXPECT_EQ(cost.prior, 0.0);
  const double s = evaluated_residuals(image, house, options);
  EXPECT_NEAR(cost.squared_residuals, s, 1e-9 * s);
  EXPECT_NEAR(cost.total, s / 0.04 + 20 * std::log(inside_evidence(image)), 1e-9 * cost.total);
  EXPECT_NEAR(parameter_price(image), std::log(inside_evidence(image)), 1e-12);
}

TEST(PenalisedCost, AnLSharesItsEavesAndTheHipsAtItsCorner) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {-7.0, -6.0, 15.0, 6.0, 13.0, 5.0};
  house.roofs = {hip_roof(5.0, 2.0, 0.2, 0.2, Axis::kX), hip_roof(5.0, 2.0, 0.2, 0.2, Axis::kY)};
  const HeightImage image = image_of(house);
  // 1 + 6 + 4 + 4, less one eaves and two hips.
  EXPECT_EQ(derivation_cost(image, house).num_parameters, 12);
  EXPECT_NEAR(derivation_cost(image, house).prior, 0.0, 1e-12);
  // Eaves 0.4 m apart lie one standard deviation of 0.2 m from their mean each.
  house.roofs[1][param::roof::kEaves] = 5.4;
  EXPECT_NEAR(derivation_cost(image, house).prior, 2.0, 1e-9);
  // A gable has no hip to share.
  house.roofs[1] = gable_roof(5.0, 2.0, Axis::kY);
  EXPECT_EQ(derivation_cost(image, house).num_parameters, 11);
}

TEST(PenalisedCost, AUSharesItsEavesAndTheHipsAtItsCorners) {
  House house = make_house(Foundation::kU);
  house.footprints[0].values = {-9.0, -6.0, 18.0, 6.0, 12.0, 5.0, 11.0, 5.0};
  house.roofs = {hip_roof(5.0, 2.0, 0.2, 0.2, Axis::kX), hip_roof(5.0, 2.0, 0.2, 0.2, Axis::kY),
                 hip_roof(5.3, 2.0, 0.2, 0.2, Axis::kY)};
  const HeightImage image = image_of(house);
  const PenalisedCost cost = derivation_cost(image, house);
  // 1 + 8 + 3 * 4, less two eaves, both of the base's hips and one of each wing's.
  EXPECT_EQ(cost.num_parameters, 15);
  // Eaves 0.1, 0.1 and 0.2 m from their mean.
  EXPECT_NEAR(cost.prior, (0.01 + 0.01 + 0.04) / 0.04, 1e-9);
  EXPECT_NEAR(cost.total, 15 * parameter_price(image) + cost.prior, 1e-9);
}

TEST(PenalisedCost, ChargesLowFlatBlocksBesideOthers) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 8.0, -3.0, 3.0)};
  house.roofs = {gable_roof(5.0, 2.5, Axis::kX), flat_roof(3.0)};
  const HeightImage image = image_of(house);
  EXPECT_EQ(derivation_cost(image, house).prior, 15.0);
  house.roofs[1] = flat_roof(4.0);
  EXPECT_EQ(derivation_cost(image, house).prior, 0.0);
  const House alone = box_house(10.0, 8.0, flat_roof(3.0));
  EXPECT_EQ(derivation_cost(image, alone).prior, 0.0);
}

TEST(PenalisedCost, ChargesComponentsThatAreStripsOnly) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-6.0, 6.0, -4.0, 4.0), rectangle_rule(-8.0, 8.0, -6.0, 6.0)};
  house.roofs = {flat_roof(6.0), flat_roof(4.0)};
  const HeightImage image = image_of(house);
  EXPECT_EQ(penalised_cost(image, house, {}).prior, 0.0);
  house.footprints[1] = rectangle_rule(-6.5, 6.5, -4.5, 4.5);
  const HeightImage shell = image_of(house);
  EXPECT_EQ(penalised_cost(shell, house, {}).prior, 80.0);
}

TEST(PenalisedCost, ChargesBlocksThatDoNotFitWhatTheyShow) {
  const House truth = detailed_house();
  const HeightImage image = image_of(truth, {.noise = 0.1});
  House house = truth;
  EXPECT_EQ(count_unfit_blocks(image, house, 0.15), 0);
  house.garages[0][param::garage::kHeightI] += 1.0;
  EXPECT_EQ(count_unfit_blocks(image, house, 0.15), 1);
  house.roofs[0][param::roof::kEaves] += 1.0;
  EXPECT_EQ(count_unfit_blocks(image, house, 0.15), 2);
  // Dormers and chimneys are small: they are not counted.
  house = truth;
  house.chimneys[0][param::chimney::kHeight] += 1.0;
  house.dormers[0][param::dormer::kEaves] += 1.0;
  EXPECT_EQ(count_unfit_blocks(image, house, 0.15), 0);

  house = truth;
  house.garages[0][param::garage::kHeightI] += 1.0;
  const PenaltyOptions options;
  const PenalisedCost cost = penalised_cost(image, house, options);
  EXPECT_NEAR(cost.prior, 80.0, 1e-9);
  EXPECT_NEAR(cost.total,
              evaluated_residuals(image, house, options) / (0.15 * 0.15) +
                  20 * parameter_price(image) + 80.0,
              1e-6);
}

TEST(PenalisedCost, ChargesAFoundationWhatItIsToldTo) {
  const House house = box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3);
  const HeightImage image = image_of(house);
  PenaltyOptions options;
  const PenalisedCost free = penalised_cost(image, house, options);
  options.foundation_charge = {17.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  const PenalisedCost charged = penalised_cost(image, house, options);
  EXPECT_NEAR(charged.prior, free.prior + 17.0, 1e-12);
  EXPECT_NEAR(charged.total, free.total + 17.0, 1e-9);
  EXPECT_EQ(charged.squared_residuals, free.squared_residuals);
}

TEST(PenalisedCost, FallsWithoutARuleThatIsNotThereAndRisesWithoutOneThatIs) {
  const House bare = box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3);
  const House full = detailed_house();
  PenaltyOptions options;
  options.noise = 0.1;
  const HeightImage bare_image = image_of(bare, {.noise = 0.1});
  const HeightImage full_image = image_of(full, {.noise = 0.1});
  for (std::vector<Rule> House::*list : {&House::dormers, &House::chimneys, &House::garages}) {
    House with = bare;
    with.*list = full.*list;
    EXPECT_LT(penalised_cost(bare_image, bare, options).total,
              penalised_cost(bare_image, with, options).total);
    House without = full;
    (without.*list).clear();
    EXPECT_GT(penalised_cost(full_image, without, options).total,
              penalised_cost(full_image, full, options).total);
  }
}

}  // namespace
}  // namespace gable
