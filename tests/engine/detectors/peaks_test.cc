#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/detectors/peaks.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gable {
namespace {

using Map = std::vector<float>;

Map empty_map() { return Map(kCropPixels, 0.0f); }

float& at(Map& map, int row, int col) { return map[static_cast<size_t>(row) * kCropSize + col]; }

// Adds a bump of height 1 as the training draws them.
void add_bump(const Eigen::Vector2d& crop, double sigma, Map* map) {
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const double d2 = (Eigen::Vector2d(col + 0.5, row + 0.5) - crop).squaredNorm();
      float& value = at(*map, row, col);
      value = std::max(value, static_cast<float>(std::exp(-0.5 * d2 / (sigma * sigma))));
    }
  }
}

TEST(Peaks, AreThePixelsThatNoneAroundExceedsAsASlowSearchFindsThem) {
  Random random(5);
  for (int radius = 1; radius <= 4; ++radius) {
    Map map = empty_map();
    // Few different values, so that plateaus occur.
    for (float& value : map) value = 0.1f * static_cast<float>(random.integer(0, 10));
    std::set<std::pair<int, int>> expected;
    for (int row = 0; row < kCropSize; ++row) {
      for (int col = 0; col < kCropSize; ++col) {
        bool peak = at(map, row, col) >= 0.5f;
        for (int i = 0; i < static_cast<int>(kCropPixels); ++i) {
          const int r = i / kCropSize, c = i % kCropSize;
          if (std::abs(r - row) > radius || std::abs(c - col) > radius) continue;
          const float difference = map[i] - at(map, row, col);
          if (difference > 0.0f) peak = false;
          if (difference == 0.0f && i < row * kCropSize + col) peak = false;
        }
        if (peak) expected.insert({row, col});
      }
    }
    PeakOptions options;
    options.radius = radius;
    options.at_most = static_cast<int>(kCropPixels);
    const std::vector<Peak> peaks = find_peaks(map, options);
    std::set<std::pair<int, int>> found;
    for (const Peak& peak : peaks) {
      // A position sharpened to the border between two pixels may belong to either.
      for (const auto& [row, col] : expected) {
        if (std::abs(peak.crop.x() - col - 0.5) <= 0.5 &&
            std::abs(peak.crop.y() - row - 0.5) <= 0.5 && peak.value == at(map, row, col)) {
          found.insert({row, col});
        }
      }
    }
    EXPECT_EQ(peaks.size(), expected.size()) << radius;
    EXPECT_EQ(found, expected) << radius;
    EXPECT_GT(expected.size(), 10u);
    EXPECT_TRUE(std::is_sorted(peaks.begin(), peaks.end(),
                               [](const Peak& a, const Peak& b) { return a.value > b.value; }));
  }
}

TEST(Peaks, AreFoundToATwentiethOfAPixel) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d center(random.uniform(4.0, 60.0), random.uniform(4.0, 60.0));
    Map map = empty_map();
    add_bump(center, 1.8, &map);
    const std::vector<Peak> peaks = find_peaks(map);
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_LT((peaks[0].crop - center).lpNorm<Eigen::Infinity>(), 0.05) << center.transpose();
  }
}

TEST(Peaks, AParabolaIsFoundExactly) {
  Map map = empty_map();
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const double dx = col + 0.5 - 30.8, dy = row + 0.5 - 12.35;
      at(map, row, col) = static_cast<float>(0.9 - 0.01 * dx * dx - 0.02 * dy * dy);
    }
  }
  const std::vector<Peak> peaks = find_peaks(map);
  ASSERT_EQ(peaks.size(), 1u);
  EXPECT_NEAR(peaks[0].crop.x(), 30.8, 1e-4);
  EXPECT_NEAR(peaks[0].crop.y(), 12.35, 1e-4);
}

TEST(Peaks, StayInsideTheirPixelAtTheBorder) {
  Map map = empty_map();
  at(map, 0, 63) = 0.9f;
  at(map, 63, 0) = 0.8f;
  at(map, 62, 0) = 0.7f;
  const std::vector<Peak> peaks = find_peaks(map);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_EQ(peaks[0].crop, Eigen::Vector2d(63.5, 0.5));
  EXPECT_EQ(peaks[1].crop, Eigen::Vector2d(0.5, 63.5));
}

TEST(Peaks, NoNumbersAreNoPeaks) {
  Map map(kCropPixels, std::nanf(""));
  EXPECT_TRUE(find_peaks(map).empty());
  at(map, 20, 20) = 0.7f;
  for (const Peak& peak : find_peaks(map)) EXPECT_EQ(peak.crop, Eigen::Vector2d(20.5, 20.5));
}

TEST(Peaks, TheHighestAreKept) {
  Map map = empty_map();
  for (int i = 0; i < 8; ++i) at(map, 4 + 6 * i, 10) = 0.55f + 0.05f * static_cast<float>(i % 4);
  PeakOptions options;
  options.at_most = 2;
  const std::vector<Peak> peaks = find_peaks(map, options);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_FLOAT_EQ(peaks[0].value, 0.7f);
  EXPECT_FLOAT_EQ(peaks[1].value, 0.7f);
}

TEST(Peaks, OptionsOutOfRangeAreNamed) {
  PeakOptions options;
  EXPECT_EQ(check(options), "");
  options.threshold = 0.0;
  EXPECT_EQ(check(options), "threshold must be in (0, 1]");
  options = {};
  options.radius = 0;
  EXPECT_EQ(check(options), "radius must be in [1, 16]");
  options = {};
  options.at_most = 0;
  EXPECT_EQ(check(options), "at_most must be >= 1");
}

}  // namespace
}  // namespace gable
