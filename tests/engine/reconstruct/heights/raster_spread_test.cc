#include <gable/engine/reconstruct/heights/raster_spread.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Halls of 12 m x 9 m, 5 m high, 25 m apart, each turned by another angle; heights are means over
// a square of width `spread` that lies as the hall does.
HeightRaster halls(double gsd, double spread, uint64_t seed) {
  constexpr int kHalls = 6;
  constexpr double kStep = 25.0;
  Random random(seed);
  Grid grid;
  grid.gsd = gsd;
  grid.rows = grid.cols = static_cast<int>(kHalls * kStep / gsd);
  HeightRaster heights(grid, 0.0f);
  struct Hall {
    double x, y, angle;
  };
  std::vector<Hall> all;
  for (int i = 0; i < kHalls * kHalls; ++i) {
    all.push_back({kStep * (i % kHalls + 0.5) + random.uniform(-2.0, 2.0),
                   kStep * (i / kHalls + 0.5) + random.uniform(-2.0, 2.0),
                   random.uniform(0.0, M_PI)});
  }
  // The part of [-spread / 2, spread / 2] around `at` within [-half, half].
  const auto covered = [&](double at, double half) {
    if (spread == 0.0) return std::abs(at) < half ? 1.0 : 0.0;
    const double low = std::max(at - 0.5 * spread, -half);
    const double high = std::min(at + 0.5 * spread, half);
    return std::max(0.0, high - low) / spread;
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const double x = (col + 0.5) * gsd, y = (row + 0.5) * gsd;
      const Hall& hall = all[static_cast<int>(y / kStep) * kHalls + static_cast<int>(x / kStep)];
      const double u = std::cos(hall.angle) * (x - hall.x) + std::sin(hall.angle) * (y - hall.y);
      const double v = std::cos(hall.angle) * (y - hall.y) - std::sin(hall.angle) * (x - hall.x);
      heights.at(row, col) =
          static_cast<float>(5.0 * covered(u, 6.0) * covered(v, 4.5) + random.normal(0.03));
    }
  }
  return heights;
}

double spread_of(const HeightRaster& heights) {
  return raster_spread(wall_widths(heights), heights.grid.gsd);
}

TEST(RasterSpread, IsTheWidthThatHeightsAreMeansOver) {
  for (const double gsd : {0.5, 1.0}) {
    for (const double cells : {1.0, 1.5, 2.0, 2.5}) {
      EXPECT_NEAR(spread_of(halls(gsd, cells * gsd, 1)), cells * gsd, 0.15 * gsd) << cells;
    }
  }
}

TEST(RasterSpread, IsZeroWhereEveryHeightIsThatOfOneSurface) {
  for (const double gsd : {0.25, 0.5, 1.0}) {
    const std::vector<double> widths = wall_widths(halls(gsd, 0.0, 2));
    EXPECT_GT(widths.size(), 500u);
    EXPECT_EQ(raster_spread(widths, gsd), 0.0) << gsd;
  }
}

TEST(RasterSpread, RoofsThatRiseFromTheWallDoNotCountAsRamps) {
  HeightRaster heights = halls(1.0, 1.5, 3);
  // A slope of 40 degrees on top of every hall, from its southern to its northern wall.
  for (size_t i = 0; i < heights.values.size(); ++i) {
    const double y = std::fmod(static_cast<double>(i) / heights.grid.cols, 25.0) - 12.5;
    heights.values[i] *= static_cast<float>(1.0 + 0.84 / 5.0 * std::clamp(y + 6.0, 0.0, 12.0));
  }
  EXPECT_NEAR(spread_of(heights), 1.5, 0.2);
}

TEST(RasterSpread, FewWallsTellNothing) {
  EXPECT_EQ(raster_spread(std::vector<double>(49, 2.0), 1.0), 0.0);
  EXPECT_EQ(raster_spread(std::vector<double>(50, 2.0), 1.0), 2.0);
}

TEST(RasterSpread, CellsWithoutHeightsAreNoWalls) {
  HeightRaster heights = halls(1.0, 0.0, 4);
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (float& z : heights.values) {
    if (z < 1.0f) z = none;
  }
  EXPECT_TRUE(wall_widths(heights).empty());
}

}  // namespace
}  // namespace gable
