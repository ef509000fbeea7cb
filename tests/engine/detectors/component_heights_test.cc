#include <gable/engine/detectors/component_heights.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

// A gable roof along x, 12 x 8 m, eaves at 4 m, ridge at 6.4 m.
House sample_house(double azimuth) {
  return box_house(12.0, 8.0, gable_roof(4.0, 2.4, Axis::kX), azimuth);
}

TurnedRectangle around(double azimuth) { return {azimuth, -6.0, 6.0, -4.0, 4.0}; }

TEST(ComponentHeights, AreThoseOfTheRoofAtItsEavesAndItsRidge) {
  for (const double azimuth : {0.0, 0.6}) {
    ViewOptions view;
    view.gsd = 0.1;
    view.size = 160;
    const auto heights =
        component_heights(image_of(sample_house(azimuth), view), around(azimuth), 2.0);
    ASSERT_TRUE(heights);
    // The lowest tenth of a gable roof reaches a tenth of the way up, the highest twentieth begins
    // a twentieth below the ridge.
    EXPECT_NEAR(heights->eaves, 4.0 + 0.05 * 2.4, 0.04);
    EXPECT_NEAR(heights->middle, 4.0 + 0.5 * 2.4, 0.04);
    EXPECT_NEAR(heights->top, 4.0 + 0.975 * 2.4, 0.04);
  }
}

TEST(ComponentHeights, AreOverTheTerrainAndRaisedByIt) {
  HeightImage image = image_of(sample_house(0.0));
  const auto level = component_heights(image, around(0.0), 2.0);
  for (size_t i = 0; i < image.size(); ++i) {
    image.height[i] += 3.0f;
    image.ground[i] += 3.0f;
  }
  const auto raised = component_heights(image, around(0.0), 2.0);
  EXPECT_NEAR(raised->eaves, level->eaves + 3.0, 1e-5);
  EXPECT_NEAR(raised->top, level->top + 3.0, 1e-5);
}

TEST(ComponentHeights, AreNotMovedByOutliers) {
  const auto clean = component_heights(image_of(sample_house(0.3)), around(0.3), 2.0);
  ViewOptions view;
  view.outliers = 0.04;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    view.seed = seed;
    const auto heights = component_heights(image_of(sample_house(0.3), view), around(0.3), 2.0);
    EXPECT_NEAR(heights->eaves, clean->eaves, 0.25) << seed;
    EXPECT_NEAR(heights->top, clean->top, 0.25) << seed;
  }
}

TEST(ComponentHeights, UnmeasuredAndLowPixelsDoNotCount) {
  HeightImage image = image_of(sample_house(0.0));
  EXPECT_FALSE(component_heights(image, {0.0, 7.0, 9.0, -4.0, 4.0}, 2.0));
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.height[i] > 5.0f) image.weight[i] = 0.0f;
  }
  EXPECT_LE(component_heights(image, around(0.0), 2.0)->top, 5.0);
  image.weight.assign(image.size(), 0.0f);
  EXPECT_FALSE(component_heights(image, around(0.0), 2.0));
}

TEST(ComponentHeights, TheHeightNearAPointIsTheMedianAround) {
  HeightImage image = image_of(sample_house(0.0));
  const double expected = *height_near(image, {1.3, 2.0});
  EXPECT_NEAR(expected, 4.0 + 2.4 * 0.5, 0.2);
  image.height[image.index(static_cast<int>(std::lround((image.first_center.y() - 2.0) / 0.5)),
                           static_cast<int>(std::lround((1.3 - image.first_center.x()) / 0.5)))] =
      60.0f;
  EXPECT_NEAR(*height_near(image, {1.3, 2.0}), expected, 0.31);
  EXPECT_FALSE(height_near(image, {100.0, 0.0}));
  EXPECT_FALSE(height_near(image, {std::nan(""), 0.0}));
}

}  // namespace
}  // namespace gable
