#include <gable/grammar/synthesis/ground/site_ground.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

Grid make_grid() {
  Grid grid;
  grid.north_west = {100.0, 240.0};
  grid.gsd = 0.5;
  grid.rows = 70;
  grid.cols = 90;
  return grid;
}

TEST(SiteGround, IsNoSteeperThanATenthAndItsBend) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const Eigen::Vector2d center(120.0, 220.0);
    const SiteGround ground(center, &random);
    for (double angle = 0.0; angle < 6.28; angle += 0.3) {
      const Eigen::Vector2d away = 20.0 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      EXPECT_LE(std::abs(ground.at(center + away) - ground.at(center)), 2.0 + 0.32 + 1e-9);
    }
  }
}

TEST(SiteGround, OnAGridIsThatAtTheCellsCentres) {
  Random random(1);
  const SiteGround ground({120.0, 220.0}, &random);
  const HeightRaster raster = ground.on(make_grid());
  EXPECT_FLOAT_EQ(raster.at(3, 7), static_cast<float>(ground.at({103.75, 238.25})));
}

TEST(SiteGround, TerrainErrorIsSmoothAndWithinItsBound) {
  double most = 0.0;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    HeightRaster terrain(make_grid(), 0.0f);
    add_terrain_error(0.4, &random, &terrain);
    for (int row = 1; row < terrain.grid.rows; ++row) {
      for (int col = 0; col < terrain.grid.cols; ++col) {
        most = std::max<double>(most, std::abs(terrain.at(row, col)));
        // The shortest wave is 10 m long.
        EXPECT_LE(std::abs(terrain.at(row, col) - terrain.at(row - 1, col)),
                  0.4 * 2.0 * M_PI / 10.0 * 0.5 + 1e-6);
      }
    }
  }
  EXPECT_LE(most, 0.4 + 1e-6);
  EXPECT_GT(most, 0.2);
}

TEST(SiteGround, NoTerrainErrorChangesNothing) {
  Random random(4);
  HeightRaster terrain(make_grid(), 7.5f);
  add_terrain_error(0.0, &random, &terrain);
  for (float height : terrain.values) ASSERT_EQ(height, 7.5f);
}

}  // namespace
}  // namespace gable
