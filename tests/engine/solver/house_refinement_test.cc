#include <gable/engine/solver/house_refinement.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

// A hip, a gable and a garage, further apart than the widest support so that no wall is
// drawn to another.
House two_blocks() {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = 0.35;
  house.footprints = {rectangle_rule(-7.5, 3.0, -4.0, 4.0), rectangle_rule(5.0, 9.5, -3.0, 2.5)};
  house.roofs = {hip_roof(5.5, 3.0, 0.3, 0.25, Axis::kX), gable_roof(4.0, 1.8, Axis::kX)};
  Rule garage = make_rule(RuleKind::kGarageI);
  garage.values = {-2.0, 8.0, 5.0, 4.0, 2.7};
  house.garages = {garage};
  return house;
}

// Moves every parameter a little.
House disturbed(const House& truth, uint64_t seed) {
  House house = truth;
  Random random(seed);
  for (Rule* rule : house.derivation()) {
    const auto specs = parameter_specs(rule->kind);
    for (int k = 0; k < rule->size(); ++k) {
      const double reach = specs[k].unit == "m" ? 0.3 : 0.03;
      (*rule)[k] += random.uniform(-reach, reach);
    }
  }
  return house;
}

// Fine pixels, so that walls are seen where they are.
const ViewOptions kFine{.gsd = 0.1, .size = 250};

void expect_near(const House& found, const House& truth, double tolerance) {
  const auto rules = found.derivation(), expected = truth.derivation();
  for (size_t b = 0; b < rules.size(); ++b) {
    for (int k = 0; k < rules[b]->size(); ++k) {
      const auto spec = parameter_specs(rules[b]->kind)[k];
      EXPECT_NEAR((*rules[b])[k], (*expected[b])[k], tolerance)
          << rule_name(rules[b]->kind) << " " << spec.name;
    }
  }
}

TEST(HouseRefinement, ReturnsToTheTruthOfNoiseFreeHeights) {
  const House truth = two_blocks();
  const HeightImage image = image_of(truth, kFine);
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    House house = disturbed(truth, seed);
    const RefinementSummary summary = refine_house(image, {}, &house);
    SCOPED_TRACE(seed);
    expect_near(house, truth, 0.01);
    EXPECT_LT(summary.mad, 0.02);
    EXPECT_GE(summary.rmse, summary.mad);
    EXPECT_EQ(summary.stages.size(), 3u);
    EXPECT_EQ(summary.num_samples, 250 * 250);
    for (const MinimizerSummary& stage : summary.stages) {
      EXPECT_LE(stage.final_cost, stage.initial_cost);
    }
  }
}

TEST(HouseRefinement, FindsWallsToCentimetresInMetreCellsWhoseHeightsAreMeans) {
  const House truth = two_blocks();
  HeightImage image = image_of_means(truth, 1.8, {.gsd = 1.0, .size = 26});
  House house = disturbed(truth, 5);
  const RefinementSummary summary = refine_house(image, {}, &house);
  expect_near(house, truth, 0.05);
  EXPECT_LT(summary.mad, 0.03);
  // Taken for first returns, the same heights put walls somewhere within a cell.
  image.spread = 0.0;
  house = disturbed(truth, 5);
  refine_house(image, {}, &house);
  double worst = 0.0;
  for (int k = 0; k < 4; ++k) {
    worst = std::max(worst, std::abs(house.footprints[0][k] - truth.footprints[0][k]));
  }
  EXPECT_GT(worst, 0.1);
}

TEST(HouseRefinement, FindsAMansardsBreakFromAGablesEavesAndRise) {
  const House truth = box_house(13.0, 10.0, mansard_roof(3.0, 4.5, 0.72, 0.25, Axis::kY), 0.35);
  const HeightImage image = image_of(truth, {.noise = 0.1, .outliers = 0.02});
  House house = truth;
  house.azimuth[0] += 0.03;
  house.footprints[0].values = {0.5, -0.4, 12.0, 10.6};
  house.roofs[0] = mansard_roof(4.0, 3.0, 0.65, 0.3, Axis::kY);
  refine_house(image, {}, &house);
  EXPECT_NEAR(house.azimuth[0], truth.azimuth[0], 0.005);
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(house.footprints[0][k], truth.footprints[0][k], 0.1) << k;
    EXPECT_NEAR(house.roofs[0][k], truth.roofs[0][k], k < 2 ? 0.1 : 0.015) << k;
  }
}

TEST(HouseRefinement, KeepsEveryParameterWithinItsBounds) {
  // A chimney wider than chimneys are, a dormer higher than they are and a hip beyond the middle.
  House truth = box_house(12.0, 8.0, hip_roof(5.0, 2.5, 0.5, 0.4, Axis::kX), 0.3);
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {3.0, 0.5, 2.4, 9.5};
  truth.chimneys = {chimney};
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.component = 0;
  dormer.values = {-1.0, -2.2, 2.5, 2.6, 6.0, 2.6};
  truth.dormers = {dormer};
  const HeightImage image = image_of(truth);
  House house = truth;
  house.roofs[0][param::roof::kHipStart] = 0.7;  // a start outside its bounds
  refine_house(image, {}, &house);
  for (const Rule* rule : house.derivation()) {
    const auto specs = parameter_specs(rule->kind);
    for (int k = 0; k < rule->size(); ++k) {
      EXPECT_GE((*rule)[k], specs[k].lower) << specs[k].name;
      EXPECT_LE((*rule)[k], specs[k].upper) << specs[k].name;
    }
  }
  EXPECT_EQ(house.chimneys[0][param::chimney::kSide], 1.6);
}

TEST(HouseRefinement, OnlyRulesMovesNothingElse) {
  const House truth = two_blocks();
  const HeightImage image = image_of(truth);
  const House start = disturbed(truth, 2);
  House house = start;
  RefinementOptions options;
  options.only_rules = {house.roof_block(0)};
  refine_house(image, options, &house);
  for (size_t b = 0; b < house.derivation().size(); ++b) {
    const bool same = house.derivation()[b]->values == start.derivation()[b]->values;
    EXPECT_EQ(same, static_cast<int>(b) != house.roof_block(0)) << b;
  }

  house = start;
  options = {};
  options.refine_azimuth = false;
  refine_house(image, options, &house);
  EXPECT_EQ(house.azimuth.values, start.azimuth.values);
  EXPECT_NE(house.roofs[0].values, start.roofs[0].values);
}

TEST(HouseRefinement, DeviationsAreTheSpreadOverTheNoise) {
  const House truth = box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3);
  const int seeds = 40;
  std::vector<double> sum(2, 0.0), squares(2, 0.0), reported(2, 0.0);
  for (int seed = 1; seed <= seeds; ++seed) {
    const HeightImage image = image_of(truth, {.noise = 0.15, .seed = static_cast<uint64_t>(seed)});
    House house = truth;
    const RefinementSummary summary = refine_house(image, {}, &house);
    ASSERT_EQ(summary.deviations.size(), 3u);
    for (int k = 0; k < 2; ++k) {
      const double error = house.roofs[0][k] - truth.roofs[0][k];
      sum[k] += error;
      squares[k] += error * error;
      reported[k] += summary.deviations[house.roof_block(0)][k] / seeds;
    }
  }
  for (int k = 0; k < 2; ++k) {
    const double spread = std::sqrt((squares[k] - sum[k] * sum[k] / seeds) / (seeds - 1));
    EXPECT_LT(reported[k], 2.0 * spread) << k;
    EXPECT_GT(reported[k], 0.5 * spread) << k;
    EXPECT_LT(std::abs(sum[k] / seeds), 0.02) << k;
  }
}

TEST(HouseRefinement, SkipsDeviationsThatAreNotAskedFor) {
  House house = box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3);
  RefinementOptions options;
  options.deviations = false;
  const RefinementSummary summary = refine_house(image_of(house), options, &house);
  EXPECT_TRUE(summary.deviations.empty());
  EXPECT_GT(summary.num_samples, 0);
}

TEST(HouseRefinement, CheckNamesTheViolatedBound) {
  const auto with = [](auto change) {
    RefinementOptions options;
    change(&options);
    return check(options);
  };
  EXPECT_EQ(check(RefinementOptions{}), "");
  using Options = RefinementOptions;
  EXPECT_EQ(with([](Options* o) { o->stages.clear(); }), "stages must not be empty");
  EXPECT_EQ(with([](Options* o) { o->stages[1].support = 0.0; }), "support must lie in (0, 100]");
  EXPECT_EQ(with([](Options* o) { o->stages[1].support = NAN; }), "support must lie in (0, 100]");
  EXPECT_EQ(with([](Options* o) { o->stages[2].loss_scale = 101.0; }),
            "loss_scale must lie in (0, 100]");
  EXPECT_EQ(with([](Options* o) { o->stages[0].stride = 0; }), "stride must lie in [1, 64]");
  EXPECT_EQ(with([](Options* o) { o->stages[0].max_iterations = 1001; }),
            "max_iterations must lie in [1, 1000]");
  EXPECT_EQ(with([](Options* o) { o->function_tolerance = 1.0; }),
            "function_tolerance must lie in [0, 1)");
  EXPECT_EQ(with([](Options* o) { o->height_deviation = 0.0; }),
            "height_deviation must lie in (0, 100]");
}

}  // namespace
}  // namespace gable
