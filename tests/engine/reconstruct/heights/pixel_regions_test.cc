#include <gable/engine/reconstruct/heights/pixel_regions.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gable {
namespace {

cv::Mat random_mask(uint64_t seed) {
  Random random(seed);
  cv::Mat mask = cv::Mat::zeros(17, 23, CV_8U);
  for (int row = 0; row < mask.rows; ++row) {
    for (int col = 0; col < mask.cols; ++col) {
      mask.at<unsigned char>(row, col) = random.chance(0.35) ? 1 : 0;
    }
  }
  return mask;
}

// Pixels reached from one over edges and corners, one step after the other.
std::set<size_t> reached(const cv::Mat& mask, size_t from) {
  std::set<size_t> all = {from};
  std::vector<size_t> open = {from};
  while (!open.empty()) {
    const int row = static_cast<int>(open.back()) / mask.cols;
    const int col = static_cast<int>(open.back()) % mask.cols;
    open.pop_back();
    for (int r = std::max(0, row - 1); r <= std::min(mask.rows - 1, row + 1); ++r) {
      for (int c = std::max(0, col - 1); c <= std::min(mask.cols - 1, col + 1); ++c) {
        const size_t i = static_cast<size_t>(r) * mask.cols + c;
        if (mask.at<unsigned char>(r, c) && all.insert(i).second) open.push_back(i);
      }
    }
  }
  return all;
}

TEST(PixelRegions, AreThoseThatAFloodFillsWithTheirBoxes) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const cv::Mat mask = random_mask(seed);
    size_t sum = 0;
    for (const PixelRegion& region : connected_regions(mask)) {
      sum += region.pixels.size();
      const std::set<size_t> flood = reached(mask, region.pixels.front());
      EXPECT_TRUE(
          std::equal(flood.begin(), flood.end(), region.pixels.begin(), region.pixels.end()));
      PixelBox box{mask.rows, 0, mask.cols, 0};
      for (size_t i : flood) {
        const int row = static_cast<int>(i) / mask.cols, col = static_cast<int>(i) % mask.cols;
        box = {std::min(box.row0, row), std::max(box.row1, row + 1), std::min(box.col0, col),
               std::max(box.col1, col + 1)};
      }
      EXPECT_EQ(region.box.row0, box.row0);
      EXPECT_EQ(region.box.row1, box.row1);
      EXPECT_EQ(region.box.col0, box.col0);
      EXPECT_EQ(region.box.col1, box.col1);
    }
    EXPECT_EQ(sum, static_cast<size_t>(cv::countNonZero(mask)));
  }
}

TEST(PixelRegions, LargestComeFirst) {
  const std::vector<PixelRegion> regions = largest_regions(random_mask(7));
  ASSERT_GT(regions.size(), 2u);
  for (size_t i = 1; i < regions.size(); ++i) {
    EXPECT_GE(regions[i - 1].pixels.size(), regions[i].pixels.size());
  }
}

TEST(PixelRegions, OfNothingAreNone) {
  EXPECT_TRUE(connected_regions(cv::Mat::zeros(5, 5, CV_8U)).empty());
}

}  // namespace
}  // namespace gable
