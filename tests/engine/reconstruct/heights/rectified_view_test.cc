#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/house_image.h"

namespace gable {
namespace {

// The pixel whose centre is nearest to a point, by looking at all of them.
size_t nearest_pixel(const HeightImage& image, const Eigen::Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  size_t best = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const double distance = (image.center_of(row, col) - p).squaredNorm();
      if (distance < least) {
        least = distance;
        best = image.index(row, col);
      }
    }
  }
  return best;
}

TEST(RectifiedView, ACellHoldsTheValuesOfTheNearestPixel) {
  HeightImage image = image_of(box_house(9.0, 6.0, gable_roof(5.0, 2.0, Axis::kX)), {0.4, 40});
  Random random(3);
  for (size_t i = 0; i < image.size(); ++i) {
    image.height[i] += static_cast<float>(random.uniform(0.0, 1.0));
    image.ground[i] = static_cast<float>(random.uniform(-1.0, 1.0));
    image.weight[i] = static_cast<float>(random.uniform(0.1, 1.0));
  }
  for (const double azimuth : {0.0, 0.4, 1.2}) {
    const RectifiedView view = rectify(image, azimuth, 0.5, 1.5);
    ASSERT_EQ(view.height.size(), static_cast<size_t>(view.rows) * view.cols);
    const Eigen::Vector2d axis_x(std::cos(azimuth), std::sin(azimuth));
    const Eigen::Vector2d axis_y(-std::sin(azimuth), std::cos(azimuth));
    for (int row = 0; row < view.rows; ++row) {
      for (int col = 0; col < view.cols; ++col) {
        const Eigen::Vector2d p = 0.5 * (view.x_edge(col) + view.x_edge(col + 1)) * axis_x +
                                  0.5 * (view.y_edge(row) + view.y_edge(row + 1)) * axis_y;
        const size_t from = nearest_pixel(image, p), to = view.index(row, col);
        ASSERT_EQ(view.height[to], image.height[from]) << azimuth << ": " << row << ", " << col;
        ASSERT_EQ(view.ground[to], image.ground[from]);
        ASSERT_EQ(view.weight[to], image.weight[from]);
        ASSERT_EQ(view.inside[to], image.inside[from]);
      }
    }
  }
}

TEST(RectifiedView, ReachesTheMarginBeyondTheOutermostInsidePixels) {
  const double azimuth = 0.7, margin = 2.0, cell = 0.5;
  const HeightImage image = image_of(box_house(9.0, 6.0, flat_roof(5.0), azimuth));
  const RectifiedView view = rectify(image, azimuth, cell, margin);
  double x_min = 1e9, x_max = -1e9, y_min = 1e9, y_max = -1e9;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      if (!image.inside[image.index(row, col)]) continue;
      const Eigen::Vector2d p = image.center_of(row, col);
      const double x = p.dot(Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth)));
      const double y = p.dot(Eigen::Vector2d(-std::sin(azimuth), std::cos(azimuth)));
      x_min = std::min(x_min, x), x_max = std::max(x_max, x);
      y_min = std::min(y_min, y), y_max = std::max(y_max, y);
    }
  }
  EXPECT_NEAR(view.x0, x_min - margin, 1e-9);
  EXPECT_NEAR(view.y0, y_min - margin, 1e-9);
  EXPECT_GE(view.x_edge(view.cols), x_max + margin - 1e-9);
  EXPECT_LT(view.x_edge(view.cols), x_max + margin + cell);
  EXPECT_GE(view.y_edge(view.rows), y_max + margin - 1e-9);
  EXPECT_LT(view.y_edge(view.rows), y_max + margin + cell);
}

TEST(RectifiedView, GivesCellsBeyondTheImageNoWeight) {
  // The house fills the image, so the margin lies outside it.
  const HeightImage image = image_of(box_house(30.0, 30.0, flat_roof(5.0)), {0.5, 20});
  const RectifiedView view = rectify(image, 0.0, 0.5, 1.0);
  for (int row = 0; row < view.rows; ++row) {
    for (int col = 0; col < view.cols; ++col) {
      const double x = view.x_edge(col) + 0.25, y = view.y_edge(row) + 0.25;
      const bool within = std::abs(x) < 4.99 && std::abs(y) < 4.99;
      const bool outside = std::abs(x) > 5.01 || std::abs(y) > 5.01;
      const size_t i = view.index(row, col);
      if (within) {
        EXPECT_EQ(view.weight[i], 1.0f);
      } else if (outside) {
        EXPECT_EQ(view.weight[i], 0.0f);
        EXPECT_EQ(view.inside[i], 0);
      }
    }
  }
}

TEST(RectifiedView, HasNoCellsWithoutInsidePixels) {
  HeightImage image = image_of(box_house(9.0, 6.0, flat_roof(5.0)));
  image.inside.assign(image.size(), 0);
  const RectifiedView view = rectify(image, 0.3, 0.5, 1.5);
  EXPECT_EQ(view.rows, 0);
  EXPECT_EQ(view.cols, 0);
  EXPECT_TRUE(view.height.empty());
}

}  // namespace
}  // namespace gable
