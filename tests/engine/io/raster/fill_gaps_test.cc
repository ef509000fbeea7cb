#include <gable/engine/io/raster/fill_gaps.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

HeightRaster row_of(const std::vector<float>& values) {
  HeightRaster raster({{0, 0}, 0.5, 1, static_cast<int>(values.size())}, 0.0f);
  raster.values = values;
  return raster;
}

void expect_row(const std::vector<float>& from, int reach, const std::vector<float>& to) {
  const HeightRaster filled = fill_narrow_gaps(row_of(from), reach);
  for (size_t i = 0; i < to.size(); ++i) {
    if (std::isnan(to[i])) {
      EXPECT_TRUE(std::isnan(filled.values[i])) << i << ": " << filled.values[i];
    } else {
      EXPECT_FLOAT_EQ(filled.values[i], to[i]) << i;
    }
  }
}

TEST(FillNarrowGaps, SlopesAreLinear) {
  expect_row({1.0f, kNan, kNan, 1.6f}, 2, {1.0f, 1.2f, 1.4f, 1.6f});
}

TEST(FillNarrowGaps, WallsAreNotSmeared) {
  expect_row({0.0f, kNan, kNan, 5.0f}, 2, {0.0f, 0.0f, 5.0f, 5.0f});
  expect_row({0.0f, kNan, 5.0f}, 2, {0.0f, 5.0f, 5.0f});
}

TEST(FillNarrowGaps, WideGapsAndEdgesStay) {
  expect_row({kNan, 1.0f, kNan, kNan, kNan, 1.0f}, 2, {kNan, 1.0f, kNan, 1.0f, kNan, 1.0f});
}

TEST(FillNarrowGaps, TheNarrowestDirectionCounts) {
  HeightRaster raster({{0, 0}, 0.5, 3, 5}, kNan);
  for (int col = 0; col < 5; ++col) raster.at(0, col) = raster.at(2, col) = 3.0f;
  raster.at(1, 0) = raster.at(1, 4) = 3.8f;
  EXPECT_FLOAT_EQ(fill_narrow_gaps(raster, 3).at(1, 2), 3.0f);
}

}  // namespace
}  // namespace gable
