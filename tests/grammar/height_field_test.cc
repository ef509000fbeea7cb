#include <gable/grammar/height_field.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

House gabled_house() {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {0.0, 0.0, 10.0, 8.0};
  house.roofs[0].values = {3.0, 2.0};
  return house;
}

TEST(HeightField, GableRoofRisesFromEavesToRidge) {
  const HeightField field(gabled_house());
  EXPECT_DOUBLE_EQ(field.at_local({0.0, 0.0}, 0.0, 0.0), 5.0);
  EXPECT_DOUBLE_EQ(field.at_local({4.9, 2.0}, 0.0, 0.0), 4.0);
  EXPECT_DOUBLE_EQ(field.at_local({0.0, -4.0}, 0.0, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(field.at_local({5.1, 0.0}, 0.0, -0.25), -0.25);
}

TEST(HeightField, HipRunsFromTheWallToTheRidge) {
  House house = gabled_house();
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0].values = {3.0, 2.0, 0.2, 0.4};
  const HeightField field(house);
  EXPECT_DOUBLE_EQ(field.at_local({-4.0, 0.0}, 0.0, 0.0), 4.0);
  EXPECT_DOUBLE_EQ(field.at_local({-3.0, 0.0}, 0.0, 0.0), 5.0);
  EXPECT_DOUBLE_EQ(field.at_local({4.0, 0.0}, 0.0, 0.0), 3.5);
  EXPECT_DOUBLE_EQ(field.at_local({1.0, 0.0}, 0.0, 0.0), 5.0);
}

TEST(HeightField, MansardRunsSteeplyToTheBreakAndFlatlyToTheRidge) {
  House house = gabled_house();
  house.roofs[0] = make_rule(RuleKind::kRoofMansard);
  house.roofs[0].values = {3.0, 4.0, 0.75, 0.25};
  const HeightField field(house);
  EXPECT_DOUBLE_EQ(field.at_local({4.9, -4.0}, 0.0, 0.0), 3.0);
  EXPECT_DOUBLE_EQ(field.at_local({4.9, -3.5}, 0.0, 0.0), 4.5);
  EXPECT_DOUBLE_EQ(field.at_local({-4.9, 3.0}, 0.0, 0.0), 6.0);
  EXPECT_DOUBLE_EQ(field.at_local({0.0, 1.5}, 0.0, 0.0), 6.5);
  EXPECT_DOUBLE_EQ(field.at_local({0.0, 0.0}, 0.0, 0.0), 7.0);
}

TEST(HeightField, ARoofIsTheMinimumOfItsFacets) {
  Random random(11);
  for (int trial = 0; trial < 4000; ++trial) {
    Rule roof = make_rule(static_cast<RuleKind>(static_cast<int>(RuleKind::kRoofFlat) + trial % 4));
    ASSERT_TRUE(is_roof(roof.kind));
    const auto specs = parameter_specs(roof.kind);
    for (int k = 0; k < roof.size(); ++k) {
      roof[k] = random.uniform(specs[k].lower, std::min(specs[k].upper, 20.0));
    }
    roof.ridge = random.chance(0.5) ? Axis::kX : Axis::kY;
    const House house = box_house(10.0, random.uniform(3.0, 18.0), roof);
    const Block<double> block = expand_blocks(house)[0];
    const double x = random.uniform(block[block_value::kX0], block[block_value::kX1]);
    const double y = random.uniform(block[block_value::kY0], block[block_value::kY1]);
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < kNumFacets; ++f) {
      const Facet facet = static_cast<Facet>(f);
      if (!has_facet(block, facet)) continue;
      least = std::min(least, facet_height<double, double>(block, facet, x, y));
    }
    EXPECT_NEAR((roof_height<double, double>(block, x, y)), least, 1e-9);
  }
}

TEST(HeightField, SupportCoveringHalfARoofEdgeAveragesItWithTheGround) {
  const HeightField field(gabled_house());
  // Centred on the gable wall at the ridge height line y = 2: half the support sees the roof.
  EXPECT_NEAR(field.at_local({5.0, 2.0}, 0.5, 0.0), 0.5 * 4.0, 1e-12);
  EXPECT_NEAR(field.at_local({5.0, 2.0}, 0.5, 1.0), 0.5 * 4.0 + 0.5 * 1.0, 1e-12);
}

TEST(HeightField, CoverageTimesHeightIsTheIntegralOverTheSupport) {
  const HeightField field(gabled_house());
  // Monte-Carlo-free check: a fine grid of point samples over the support, on one roof plane.
  const Eigen::Vector2d p(-4.8, 1.7);
  const double s = 0.8;
  const int n = 400;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Eigen::Vector2d q = p + s * Eigen::Vector2d((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5);
      sum += field.at_local(q, 0.0, 0.0);
    }
  }
  EXPECT_NEAR(field.at_local(p, s, 0.0), sum / (n * n), 0.01);
}

// The mean over a rectangle, from many points.
double mean_by_points(const Block<double>& block, const CoveredPart<double>& part) {
  constexpr int kPoints = 400;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      sum += roof_height<double, double>(block, part.x0 + (i + 0.5) / kPoints * (part.x1 - part.x0),
                                         part.y0 + (j + 0.5) / kPoints * (part.y1 - part.y0));
    }
  }
  return sum / (kPoints * kPoints);
}

TEST(HeightField, MeanRoofHeightIsExactOnPlanesAndNearlySoAcrossARidge) {
  const std::vector<Block<double>> blocks = expand_blocks(gabled_house());
  const CoveredPart<double> side{1.0, 3.0, 0.5, 2.5};
  EXPECT_NEAR(mean_roof_height(blocks[0], side), mean_by_points(blocks[0], side), 1e-9);
  // The centroid is wrong by an eighth of the fall over the square, 1 m; two points by a tenth of
  // that.
  for (double v = -1.0; v <= 1.0; v += 0.125) {
    const CoveredPart<double> ridge{1.0, 3.0, v - 1.0, v + 1.0};
    EXPECT_NEAR(mean_roof_height(blocks[0], ridge), mean_by_points(blocks[0], ridge), 0.045) << v;
  }
  const CoveredPart<double> at_ridge{1.0, 3.0, -1.0, 1.0};
  EXPECT_NEAR(mean_by_points(blocks[0], at_ridge), 4.75, 1e-4);
}

TEST(HeightField, AzimuthTurnsTheHouseAnticlockwise) {
  House house = gabled_house();
  house.azimuth[0] = 0.5 * M_PI;
  const HeightField field(house);
  EXPECT_NEAR(field.at_local({2.0, 4.9}, 0.0, 0.0), 4.0, 1e-12);
  EXPECT_EQ(field.at_local({4.9, 2.0}, 0.0, 0.0), 0.0);
}

TEST(HeightField, ChimneyIsBlendedOverTheRoofNotTheGround) {
  House house = gabled_house();
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {0.0, 2.0, 1.0, 6.0};
  house.chimneys.push_back(chimney);
  const HeightField field(house);
  EXPECT_NEAR(field.at_local({0.5, 2.0}, 0.5, 0.0), 4.0 + 0.5 * 2.0, 1e-12);
}

TEST(HeightField, DormerEndsAtItsComponentsWall) {
  House house = gabled_house();
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.values = {0.0, 4.0, 2.0, 2.0, 4.5, 0.5};
  dormer.component = 0;
  house.dormers.push_back(dormer);
  const HeightField field(house);
  EXPECT_NEAR(field.at_local({0.0, 3.99}, 0.0, 0.0), 5.0, 1e-12);
  EXPECT_EQ(field.at_local({0.0, 4.01}, 0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace gable
