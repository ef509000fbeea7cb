#include <gable/engine/reconstruct/choice/leftovers.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kNoise = 0.1;

// As details are priced when a house is chosen.
LeftoverOptions options() {
  LeftoverOptions out;
  out.penalty = {0.25, LossKind::kGemanMcClure, 0.65, kNoise};
  return out;
}

House bare_house() { return box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.4); }

Rule chimney() {
  Rule rule = make_rule(RuleKind::kChimney);
  rule.values = {3.5, 0.4, 1.0, 9.0};
  return rule;
}

Rule dormer() {
  Rule rule = make_rule(RuleKind::kDormer);
  rule.component = 0;
  rule.values = {-2.0, -2.4, 2.6, 2.8, 6.5, 0.7};
  return rule;
}

Rule garage() {
  Rule rule = make_rule(RuleKind::kGarageI);
  rule.values = {8.0, 0.5, 4.0, 5.0, 2.6};
  return rule;
}

TEST(Leftovers, AChimneyADormerOrAGarageThatIsMissingComesBack) {
  for (const Rule& missing : {chimney(), dormer(), garage()}) {
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      House truth = bare_house();
      std::vector<Rule> House::*list = missing.kind == RuleKind::kChimney  ? &House::chimneys
                                       : missing.kind == RuleKind::kDormer ? &House::dormers
                                                                           : &House::garages;
      (truth.*list).push_back(missing);
      const HeightImage image = image_of(truth, {.noise = kNoise, .seed = seed});
      House house = bare_house();
      EXPECT_EQ(add_leftovers(image, options(), &house), 1) << rule_name(missing.kind);
      EXPECT_EQ(house.dormers.size() + house.chimneys.size() + house.garages.size(), 1u);
      ASSERT_EQ((house.*list).size(), 1u) << rule_name(missing.kind) << ", seed " << seed;
      const Rule& found = (house.*list)[0];
      EXPECT_EQ(found.kind, missing.kind);
      EXPECT_LT(std::hypot(found[0] - missing[0], found[1] - missing[1]), 0.5)
          << rule_name(missing.kind) << ", seed " << seed;
      // The other rules are not touched.
      EXPECT_EQ(house.roofs[0].values, truth.roofs[0].values);
      EXPECT_EQ(house.footprints[0].values, truth.footprints[0].values);
      EXPECT_EQ(house.azimuth.values, truth.azimuth.values);
    }
  }
}

TEST(Leftovers, AllOfThemComeBackTogether) {
  House truth = bare_house();
  truth.chimneys = {chimney()};
  truth.dormers = {dormer()};
  truth.garages = {garage()};
  House house = bare_house();
  EXPECT_EQ(add_leftovers(image_of(truth, {.noise = kNoise}), options(), &house), 3);
  EXPECT_EQ(house.chimneys.size(), 1u);
  EXPECT_EQ(house.dormers.size(), 1u);
  EXPECT_EQ(house.garages.size(), 1u);
}

TEST(Leftovers, NothingIsAddedToAPerfectModelUnderNoise) {
  House truth = bare_house();
  truth.chimneys = {chimney()};
  truth.dormers = {dormer()};
  truth.garages = {garage()};
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    House house = truth;
    const HeightImage image = image_of(truth, {.noise = kNoise, .seed = seed});
    EXPECT_EQ(add_leftovers(image, options(), &house), 0) << "seed " << seed;
    EXPECT_EQ(house.num_parameters(), truth.num_parameters());
  }
}

TEST(Leftovers, SingleOutliersAddNothing) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    House house = bare_house();
    const HeightImage image = image_of(house, {.noise = kNoise, .outliers = 0.02, .seed = seed});
    EXPECT_EQ(add_leftovers(image, options(), &house), 0) << "seed " << seed;
  }
}

TEST(DropUnpaid, TakesAwayWhatIsNotThereAndKeepsWhatIs) {
  House truth = bare_house();
  truth.chimneys = {chimney()};
  truth.dormers = {dormer()};
  truth.garages = {garage()};
  const PenaltyOptions penalty = options().penalty;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const HeightImage image = image_of(truth, {.noise = kNoise, .seed = seed});
    House house = truth;
    EXPECT_EQ(drop_unpaid(image, penalty, &house), 0);
    Rule ghost = dormer();
    ghost[param::dormer::kCenterX] = 1.5;
    ghost[param::dormer::kCenterY] = 2.4;
    house.dormers.insert(house.dormers.begin(), ghost);
    Rule second = chimney();
    second[param::chimney::kCenterX] = -5.0;
    house.chimneys.push_back(second);
    Rule shed = garage();
    shed[0] = -8.0;
    house.garages.push_back(shed);
    EXPECT_EQ(drop_unpaid(image, penalty, &house), 3) << "seed " << seed;
    ASSERT_EQ(house.dormers.size(), 1u);
    EXPECT_EQ(house.dormers[0].values, dormer().values);
    ASSERT_EQ(house.chimneys.size(), 1u);
    EXPECT_EQ(house.chimneys[0].values, chimney().values);
    ASSERT_EQ(house.garages.size(), 1u);
    EXPECT_EQ(house.garages[0].values, garage().values);
  }
}

TEST(DropUnpaid, TakesDormersAndChimneysAwayThatHaveGrownToTheirUpperBounds) {
  const PenaltyOptions penalty = options().penalty;
  const auto dropped = [&](const House& house) {
    House copy = house;
    return drop_unpaid(image_of(house, {.noise = kNoise}), penalty, &copy);
  };
  House house = bare_house();
  // They are there, but as large as their tables allow.
  house.dormers = {dormer()};
  house.dormers[0][param::dormer::kWidth] = 4.49;
  EXPECT_EQ(dropped(house), 1);
  house.dormers[0][param::dormer::kWidth] = 4.4;
  EXPECT_EQ(dropped(house), 0);
  house.dormers.clear();
  house.chimneys = {chimney()};
  house.chimneys[0][param::chimney::kSide] = 1.59;
  EXPECT_EQ(dropped(house), 1);
  house.chimneys[0][param::chimney::kSide] = 1.5;
  EXPECT_EQ(dropped(house), 0);
  // Heights and garages may be of any size.
  house.chimneys[0][param::chimney::kSide] = 0.6;
  house.chimneys[0][param::chimney::kHeight] = 11.0;
  house.garages = {garage()};
  house.garages[0][param::rectangle::kWidth] = 7.0;
  EXPECT_EQ(
      drop_unpaid(image_of(house, {.gsd = 0.2, .size = 160, .noise = kNoise}), penalty, &house), 0);
}

TEST(Leftovers, AGarageIsWiderThanWhatHeightsAreMeansOver) {
  for (const double width : {1.0, 4.0}) {
    House truth = bare_house();
    truth.garages.push_back(garage());
    truth.garages[0][2] = width;
    truth.garages[0][0] = 6.0 + 0.5 * width;
    const HeightImage image = image_of_means(truth, 1.6, {.noise = 0.03});
    House house = bare_house();
    add_leftovers(image, options(), &house);
    EXPECT_EQ(house.garages.size(), width > 2.0 ? 1u : 0u) << width;
  }
}

}  // namespace
}  // namespace gable
