#include <gable/grammar/synthesis/survey/survey_defects.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

HeightRaster make_surface(double slope_x, double slope_y) {
  Grid grid;
  grid.gsd = 0.5;
  grid.rows = 40;
  grid.cols = 50;
  HeightRaster surface(grid, 0.0f);
  for (int row = 0; row < 40; ++row) {
    for (int col = 0; col < 50; ++col) {
      surface.at(row, col) = static_cast<float>(80.0 + slope_x * col + slope_y * row);
    }
  }
  return surface;
}

TEST(SurveyDefects, BlendKeepsPlanes) {
  HeightRaster surface = make_surface(0.4, -0.3);
  const HeightRaster before = surface;
  blend_cells(1.0, &surface);
  for (int row = 1; row < 39; ++row) {
    for (int col = 1; col < 49; ++col) {
      EXPECT_NEAR(surface.at(row, col), before.at(row, col), 1e-4);
    }
  }
}

TEST(SurveyDefects, BlendSpreadsASpikeByItsWeights) {
  HeightRaster surface = make_surface(0.0, 0.0);
  surface.at(20, 20) += 16.0f;
  blend_cells(0.5, &surface);
  EXPECT_NEAR(surface.at(20, 20), 80.0 + 0.5 * 16.0 + 0.5 * 4.0, 1e-4);
  EXPECT_NEAR(surface.at(20, 21), 80.0 + 0.5 * 2.0, 1e-4);
  EXPECT_NEAR(surface.at(19, 21), 80.0 + 0.5 * 1.0, 1e-4);
  EXPECT_EQ(surface.at(20, 22), 80.0f);
}

TEST(SurveyDefects, BlendLeavesMissingCellsOut) {
  HeightRaster surface = make_surface(0.0, 0.0);
  surface.at(10, 10) = kMissing;
  blend_cells(1.0, &surface);
  EXPECT_TRUE(std::isnan(surface.at(10, 10)));
  EXPECT_EQ(surface.at(10, 11), 80.0f);
}

TEST(SurveyDefects, HolesTakeCellsAwayAndChangeNoOther) {
  int with_holes = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    HeightRaster surface = make_surface(0.1, 0.1);
    for (int row = 10; row < 25; ++row) {
      for (int col = 15; col < 30; ++col) surface.at(row, col) += 7.0f;
    }
    const HeightRaster before = surface;
    random_holes(&random, &surface);
    int missing = 0;
    for (size_t i = 0; i < surface.values.size(); ++i) {
      if (std::isnan(surface.values[i])) {
        ++missing;
      } else {
        EXPECT_EQ(surface.values[i], before.values[i]);
      }
    }
    with_holes += missing > 0;
    EXPECT_LT(missing, static_cast<int>(surface.values.size()) / 3) << seed;
  }
  EXPECT_GT(with_holes, 50);
}

}  // namespace
}  // namespace gable
