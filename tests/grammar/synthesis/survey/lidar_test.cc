#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/survey/lidar.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

Grid square_grid(int size) {
  Grid grid;
  grid.north_west = {400000.0, 200000.0};
  grid.gsd = 0.5;
  grid.rows = grid.cols = size;
  return grid;
}

TEST(SurveyNoise, SeventyPercentOfTheSamplesMoveByUniformThirtyCentimetres) {
  const HeightRaster ground(square_grid(400), 50.0f);
  HeightRaster surface = ground;
  Random random(1);
  add_survey_noise(LidarOptions(), ground, &random, &surface);
  int moved = 0;
  double sum = 0.0, sum_squares = 0.0, largest = 0.0;
  for (float height : surface.values) {
    const double noise = height - 50.0;
    if (noise == 0.0) continue;
    ++moved;
    sum += noise;
    sum_squares += noise * noise;
    largest = std::max(largest, std::abs(noise));
  }
  const double n = surface.values.size();
  EXPECT_NEAR(moved / n, 0.7, 0.005);
  EXPECT_NEAR(sum / moved, 0.0, 0.003);
  // Variance of a uniform distribution of half width a: a^2 / 3.
  EXPECT_NEAR(sum_squares / moved, 0.3 * 0.3 / 3.0, 0.0005);
  EXPECT_LE(largest, 0.3 + 1e-5);
  EXPECT_GT(largest, 0.299);
}

TEST(SurveyNoise, OutliersReplaceTheirShare) {
  const HeightRaster ground(square_grid(400), 50.0f);
  HeightRaster surface(ground.grid, 60.0f);
  LidarOptions options;
  options.noise_share = 0.0;
  options.outlier_share = 0.03;
  Random random(2);
  add_survey_noise(options, ground, &random, &surface);
  int outliers = 0;
  for (float height : surface.values) {
    if (height == 60.0f) continue;
    ++outliers;
    EXPECT_GE(height, 50.0 - 3.0);
    EXPECT_LE(height, 50.0 + 15.0);
  }
  EXPECT_NEAR(outliers / static_cast<double>(surface.values.size()), 0.03, 0.002);
}

TEST(SurveyNoise, KeepsCellsWithoutMeasurement) {
  const HeightRaster ground(square_grid(10), 50.0f);
  HeightRaster surface(ground.grid, std::nanf(""));
  LidarOptions options;
  options.outlier_share = 1.0;
  Random random(2);
  add_survey_noise(options, ground, &random, &surface);
  for (float height : surface.values) EXPECT_TRUE(std::isnan(height));
}

TEST(SurveyNoise, OptionsNameTheBoundThatFails) {
  LidarOptions options;
  EXPECT_EQ(options.check(), "");
  options.noise_share = -0.1;
  EXPECT_EQ(options.check(), "noise_share must be in [0, 1]");
}

TEST(RasteriseHouse, SetsPointSamplesInTheWorldFrame) {
  House house = make_house(Foundation::kI);
  house.origin = {400016.3, 199984.1, 70.0};
  house.azimuth[0] = 0.7;
  house.footprints[0].values = {0.0, 0.0, 12.0, 8.0};
  house.roofs[0].values = {4.0, 3.0};
  HeightRaster surface(square_grid(64), 71.0f), truth(square_grid(64), std::nanf(""));
  rasterise_house(house, &surface, &truth);
  const double c = std::cos(0.7), s = std::sin(0.7);
  int covered = 0;
  for (int row = 0; row < 64; ++row) {
    for (int col = 0; col < 64; ++col) {
      const double east = 400000.0 + 0.5 * (col + 0.5) - 400016.3;
      const double north = 200000.0 - 0.5 * (row + 0.5) - 199984.1;
      const double x = c * east + s * north, y = -s * east + c * north;
      if (std::abs(x) < 6.0 && std::abs(y) < 4.0) {
        ++covered;
        const double expected = 70.0 + 4.0 + 3.0 * (1.0 - std::abs(y) / 4.0);
        EXPECT_NEAR(surface.at(row, col), expected, 1e-4);
        EXPECT_EQ(truth.at(row, col), surface.at(row, col));
      } else {
        EXPECT_EQ(surface.at(row, col), 71.0f);
        EXPECT_TRUE(std::isnan(truth.at(row, col)));
      }
    }
  }
  EXPECT_NEAR(covered * 0.25, 96.0, 4.0);
}

}  // namespace
}  // namespace gable
