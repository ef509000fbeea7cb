#include <gable/engine/reconstruct/heights/raster_noise.h>
#include <gtest/gtest.h>

#include "engine/house_image.h"

namespace gable {
namespace {

TEST(RasterNoise, IsThatOfTheHeightsBesideRidgesAndOutliers) {
  ViewOptions view;
  for (const double noise : {0.05, 0.2}) {
    view.noise = noise;
    view.outliers = 0.01;
    const House house = box_house(16.0, 10.0, hip_roof(5.0, 3.0, 0.25, 0.25, Axis::kX), 0.4);
    EXPECT_NEAR(raster_noise(image_of(house, view)), noise, 0.25 * noise);
  }
}

TEST(RasterNoise, IsNoneOnAnExactPlaneAndWithoutNeighbourhoods) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  EXPECT_NEAR(raster_noise(image), 0.0, 1e-6);
  image.inside.assign(image.size(), 0);
  EXPECT_EQ(raster_noise(image), 0.0);
}

}  // namespace
}  // namespace gable
