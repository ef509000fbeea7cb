#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/survey/survey_sampling.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

struct Case {
  House house;
  BuiltShape shape;
  SiteGround ground;
  HeightRaster bare;
};

Case make_case(uint64_t seed) {
  Random random(seed);
  House house = random_house(&random);
  const SiteGround ground({400.0, 200.0}, &random);
  house.origin = {400.2, 200.1, ground.at({400.2, 200.1})};
  Grid grid;
  grid.north_west = {375.0, 225.0};
  grid.gsd = 0.5;
  grid.rows = grid.cols = 100;
  return {house, shape_of(house), ground, ground.on(grid)};
}

TEST(SurveySampling, OfCellCentresIsTheShapeOverTheGround) {
  for (uint64_t seed = 0; seed < 10; ++seed) {
    const Case c = make_case(seed);
    Random random(seed);
    HeightRaster surface = c.bare;
    sample_built({&c.shape}, c.ground, SurveySampling(), &random, &surface);
    for (int row = 0; row < 100; ++row) {
      for (int col = 0; col < 100; ++col) {
        const Eigen::Vector2d p = surface.grid.center_of(row, col);
        EXPECT_NEAR(surface.at(row, col), std::max(c.ground.at(p), c.shape.at(p)), 1e-4);
      }
    }
  }
}

TEST(SurveySampling, HeightsLieBetweenTheLowestAndTheHighestThatTheFootprintSees) {
  for (CellHeight height : {CellHeight::kPoint, CellHeight::kMean, CellHeight::kHighest}) {
    const Case c = make_case(11);
    SurveySampling sampling{height, height == CellHeight::kPoint ? 1 : 5, 1.6};
    Random random(5);
    HeightRaster surface = c.bare;
    sample_built({&c.shape}, c.ground, sampling, &random, &surface);
    int between = 0;
    for (int row = 0; row < 100; ++row) {
      for (int col = 0; col < 100; ++col) {
        double low = INFINITY, high = -INFINITY;
        constexpr int kSteps = 16;
        for (int i = 0; i <= kSteps; ++i) {
          for (int j = 0; j <= kSteps; ++j) {
            const Eigen::Vector2d p =
                surface.grid.center_of(row, col) +
                0.8 * Eigen::Vector2d(i / (0.5 * kSteps) - 1.0, j / (0.5 * kSteps) - 1.0) * 0.5;
            const double at = std::max(c.ground.at(p), c.shape.at(p));
            low = std::min(low, at);
            high = std::max(high, at);
          }
        }
        EXPECT_GE(surface.at(row, col), low - 0.1);
        EXPECT_LE(surface.at(row, col), high + 0.1);
        between += surface.at(row, col) > low + 1.0 && surface.at(row, col) < high - 1.0;
      }
    }
    // Only means make walls that are neither roof nor ground.
    if (height == CellHeight::kMean) {
      EXPECT_GT(between, 20);
    }
  }
}

TEST(SurveySampling, SmoothSurveysReachBeyondTheirCellsAndOthersDoNot) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(random_sampling(false, 0.5, &random).reach(), 0.0);
    const SurveySampling smooth = random_sampling(true, 0.5, &random);
    EXPECT_EQ(smooth.height, CellHeight::kMean);
    EXPECT_GE(smooth.points, 2);
    EXPECT_LE(smooth.reach(), 0.4);
  }
}

}  // namespace
}  // namespace gable
