#include <gable/residuals/house_relations.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

std::vector<double> evaluate(const House& house, const HouseRelation& relation) {
  const auto derivation = house.derivation();
  std::vector<const double*> parameters;
  for (int rule : relation.rules) parameters.push_back(derivation[rule]->values.data());
  std::vector<double> residuals(relation.cost->num_residuals());
  EXPECT_TRUE(relation.cost->Evaluate(parameters.data(), residuals.data(), nullptr));
  return residuals;
}

House two_blocks() {
  House house = make_house(Foundation::kII);
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0].values = {5.0, 2.0, 0.2, 0.45};
  house.roofs[1].values = {4.0, 2.5};
  return house;
}

TEST(HouseRelations, SayTheDifferenceTimesTheWeight) {
  const House house = two_blocks();
  EXPECT_DOUBLE_EQ(evaluate(house, equal_eaves(house, 0, 1, 2.0))[0], 2.0);
  EXPECT_DOUBLE_EQ(evaluate(house, equal_ridges(house, 0, 1, 3.0))[0], 1.5);
  EXPECT_DOUBLE_EQ(evaluate(house, symmetric_hips(house, 0, 4.0))[0], -1.0);
}

TEST(HouseRelations, ARelationWithinOneRuleHasOneParameterBlock) {
  const House house = two_blocks();
  EXPECT_EQ(symmetric_hips(house, 0, 1.0).rules, std::vector<int>{house.roof_block(0)});
}

TEST(HouseRelations, AFlatRoofsRidgeIsItsEaves) {
  House house = two_blocks();
  house.roofs[1] = make_rule(RuleKind::kRoofFlat);
  house.roofs[1][param::roof::kEaves] = 6.0;
  EXPECT_DOUBLE_EQ(evaluate(house, equal_ridges(house, 0, 1, 1.0))[0], 1.0);
}

TEST(HouseRelations, PriorsCountInDeviations) {
  const House house = two_blocks();
  const std::vector<double> r = evaluate(
      house,
      parameter_priors(
          house, {{house.roof_block(0), 0, 4.5, 0.25}, {house.roof_block(1), 1, 2.5, 0.1}}, 0.5));
  ASSERT_EQ(r.size(), 2u);
  EXPECT_DOUBLE_EQ(r[0], 1.0);
  EXPECT_NEAR(r[1], 0.0, 1e-14);
}

TEST(HouseRelations, AlikeDormersMayStandApartAlongTheRidgeOnly) {
  House house = two_blocks();
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.component = 0;
  house.dormers = {dormer, dormer};
  house.dormers[1][param::dormer::kCenterX] += 3.0;
  for (double r : evaluate(house, alike_dormers(house, 0, 1, 1.0))) EXPECT_EQ(r, 0.0);
  house.dormers[1][param::dormer::kCenterY] += 0.5;
  EXPECT_DOUBLE_EQ(evaluate(house, alike_dormers(house, 0, 1, 1.0))[4], -0.5);
}

}  // namespace
}  // namespace gable
