#include <gable/engine/reconstruct/heights/morphology.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

HeightRaster noise(int rows, int cols, uint64_t seed) {
  HeightRaster raster({{0, 0}, 0.5, rows, cols}, 0.0f);
  Random random(seed);
  for (float& z : raster.values) {
    z = random.chance(0.2) ? std::numeric_limits<float>::quiet_NaN()
                           : static_cast<float>(random.normal(3.0));
  }
  return raster;
}

/// The extremum over the square by looking at every cell of it.
HeightRaster slow(const HeightRaster& raster, int radius, bool smallest) {
  HeightRaster out(raster.grid, std::numeric_limits<float>::quiet_NaN());
  for (int r = 0; r < raster.grid.rows; ++r) {
    for (int c = 0; c < raster.grid.cols; ++c) {
      for (int i = r - radius; i <= r + radius; ++i) {
        for (int j = c - radius; j <= c + radius; ++j) {
          if (!raster.grid.contains(i, j) || std::isnan(raster.at(i, j))) continue;
          float& best = out.at(r, c);
          const float z = raster.at(i, j);
          if (std::isnan(best) || (smallest ? z < best : z > best)) best = z;
        }
      }
    }
  }
  return out;
}

void expect_same(const HeightRaster& a, const HeightRaster& b) {
  ASSERT_EQ(a.values.size(), b.values.size());
  for (size_t i = 0; i < a.values.size(); ++i) {
    ASSERT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i])))
        << "cell " << i;
  }
}

TEST(Morphology, EqualsTheExtremumOverEveryCellOfTheSquare) {
  for (const auto& [rows, cols] : {std::pair(1, 1), {1, 17}, {23, 1}, {13, 31}, {40, 22}}) {
    for (const int radius : {0, 1, 2, 5, 12, 30}) {
      const HeightRaster raster = noise(rows, cols, 7 * rows + radius);
      expect_same(erode(raster, radius), slow(raster, radius, true));
      expect_same(dilate(raster, radius), slow(raster, radius, false));
    }
  }
}

TEST(Morphology, OpeningNeverRisesAndRepeatingItChangesNothing) {
  const HeightRaster raster = noise(30, 40, 3);
  const HeightRaster opened = open(raster, 2);
  for (size_t i = 0; i < raster.values.size(); ++i) {
    if (!std::isnan(raster.values[i])) {
      EXPECT_LE(opened.values[i], raster.values[i]);
    }
  }
  expect_same(open(opened, 2), opened);
}

}  // namespace
}  // namespace gable
