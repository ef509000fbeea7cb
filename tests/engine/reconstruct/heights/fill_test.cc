#include <gable/engine/reconstruct/heights/fill.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A harmonic surface: x y and a slope.
float harmonic(const HeightRaster& raster, int row, int col) {
  const Eigen::Vector2d p = raster.grid.center_of(row, col);
  return static_cast<float>(0.002 * p.x() * p.y() + 0.05 * p.x() + 3.0);
}

TEST(FillSmoothly, RestoresAHarmonicSurfaceInsideHoles) {
  HeightRaster raster({{-30, 30}, 0.5, 150, 150}, 0.0f);
  for (int r = 0; r < 150; ++r) {
    for (int c = 0; c < 150; ++c) {
      // Away from the border, where the mirrored surface is another one.
      const bool hole = (r / 30 % 2 == 1 && c / 30 % 2 == 1) || (r + 2 * c) % 7 == 0;
      raster.at(r, c) = hole ? kNan : harmonic(raster, r, c);
    }
  }
  const HeightRaster filled = fill_smoothly(raster);
  for (int r = 2; r < 148; ++r) {
    for (int c = 2; c < 148; ++c) {
      EXPECT_NEAR(filled.at(r, c), harmonic(raster, r, c), 0.02) << r << " " << c;
    }
  }
}

TEST(FillSmoothly, KeepsWhatIsKnownAndStaysWithinItsRange) {
  HeightRaster raster({{0, 0}, 1.0, 33, 70}, kNan);
  raster.at(3, 4) = 2.0f;
  raster.at(30, 66) = 5.0f;
  const HeightRaster filled = fill_smoothly(raster);
  EXPECT_EQ(filled.at(3, 4), 2.0f);
  EXPECT_EQ(filled.at(30, 66), 5.0f);
  // Over-relaxation may leave a ripple, but none worth a tenth of the step.
  const auto [low, high] = std::minmax_element(filled.values.begin(), filled.values.end());
  EXPECT_GE(*low, 1.9f);
  EXPECT_LE(*high, 5.1f);
}

TEST(FillSmoothly, NothingKnownStaysUnknown) {
  const HeightRaster filled = fill_smoothly(HeightRaster({{0, 0}, 1.0, 5, 9}, kNan));
  EXPECT_TRUE(std::all_of(filled.values.begin(), filled.values.end(),
                          [](float z) { return std::isnan(z); }));
}

}  // namespace
}  // namespace gable
