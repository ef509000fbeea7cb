#include <gable/engine/scales/outline/raster_outline.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gable {
namespace {

/// Even-odd over all rings.
bool covers(const std::vector<OutlinedRegion>& regions, double x, double y) {
  bool in = false;
  const auto cross = [&](const Ring& ring) {
    for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector2d &a = ring[i], &b = ring[j];
      if ((a.y() > y) != (b.y() > y) &&
          x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        in = !in;
      }
    }
  };
  for (const OutlinedRegion& region : regions) {
    cross(region.outer);
    for (const Ring& hole : region.holes) cross(hole);
  }
  return in;
}

double distance_to_nearest(const std::vector<Eigen::Vector2d>& points, double x, double y) {
  double nearest = 1e9;
  for (const Eigen::Vector2d& p : points) {
    nearest = std::min(nearest, std::hypot(p.x() - x, p.y() - y));
  }
  return nearest;
}

TEST(RasterOutline, OfAFilledRectangleRunsThroughItsOutermostPixels) {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8U);
  mask(cv::Rect(20, 15, 31, 21)).setTo(255);
  for (const double inset : {0.0, 1.0, -1.0}) {
    const auto regions = outlines_of_closing(mask, 4.5, inset, 0.3);
    ASSERT_EQ(regions.size(), 1u);
    EXPECT_NEAR(regions[0].area, (30.0 - 2 * inset) * (20.0 - 2 * inset), 6.0) << inset;
    EXPECT_GT(signed_area(regions[0].outer), 0.0);
  }
}

TEST(RasterOutline, IsWhatNoEmptyDiscReaches) {
  constexpr int kSize = 56;
  constexpr double kRadius = 4.5;
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    cv::Mat mask = cv::Mat::zeros(kSize, kSize, CV_8U);
    std::vector<Eigen::Vector2d> marks;
    for (int i = 0; i < 75; ++i) {
      marks.emplace_back(random.integer(8, kSize - 9), random.integer(8, kSize - 9));
      mask.at<uint8_t>(static_cast<int>(marks.back().y()), static_cast<int>(marks.back().x())) =
          255;
    }
    const auto regions = outlines_of_closing(mask, kRadius, 0.0, 0.2);
    // Slowly: discs in half-pixel steps that hold no mark. The raster knows discs about pixels
    // alone, so what only a disc between four pixels reaches is left open.
    std::vector<Eigen::Vector2d> empty, clearly_empty;
    for (double y = 0.0; y < kSize; y += 0.5) {
      for (double x = 0.0; x < kSize; x += 0.5) {
        const double nearest = distance_to_nearest(marks, x, y);
        if (nearest > kRadius) empty.emplace_back(x, y);
        if (nearest > kRadius + std::numbers::sqrt2 / 2.0) clearly_empty.emplace_back(x, y);
      }
    }
    int checked = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        if (distance_to_nearest(clearly_empty, x, y) < kRadius - 1.5) {
          EXPECT_FALSE(covers(regions, x + 1e-4, y + 1e-4)) << x << " " << y << " seed " << seed;
          ++checked;
        }
        if (distance_to_nearest(empty, x, y) > kRadius + 1.5) {
          EXPECT_TRUE(covers(regions, x + 1e-4, y + 1e-4)) << x << " " << y << " seed " << seed;
          ++checked;
        }
      }
    }
    EXPECT_GT(checked, kSize * kSize / 2);
  }
}

TEST(RasterOutline, LeavesOutWhatHasNoWidth) {
  cv::Mat mask = cv::Mat::zeros(60, 60, CV_8U);
  EXPECT_TRUE(outlines_of_closing(mask, 4.5, -0.9, 0.8).empty());
  for (int i = 10; i < 50; ++i) mask.at<uint8_t>(i, 10 + (i - 10) * 2 / 3) = 255;
  EXPECT_TRUE(outlines_of_closing(mask, 4.5, -0.9, 0.8).empty());
}

}  // namespace
}  // namespace gable
