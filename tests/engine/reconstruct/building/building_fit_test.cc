#include <gable/engine/reconstruct/building/building_fit.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

House house() { return box_house(11.0, 7.0, hip_roof(4.0, 2.5, 0.3, 0.2, Axis::kX), 0.4); }

Building building_of(const House& house) {
  Building building;
  building.house = house;
  return building;
}

TEST(BuildingFit, AHouseIsAsFarFromItsPointSamplesAsTheirNoise) {
  const BuildingFit fit =
      fit_of_building(image_of(house(), {.noise = 0.1, .seed = 3}), building_of(house()));
  EXPECT_NEAR(fit.mad, 0.1 * std::sqrt(2.0 / M_PI), 0.01);
  EXPECT_NEAR(fit.rmse, 0.1, 0.02);
  EXPECT_EQ(fit.good, 1.0);
}

TEST(BuildingFit, MeansAreComparedWithMeans) {
  for (const double gsd : {0.5, 1.0}) {
    HeightImage image = image_of_means(house(), 1.8 * gsd, {.gsd = gsd, .size = 32});
    const BuildingFit fit = fit_of_building(image, building_of(house()));
    EXPECT_LT(fit.mad, 0.06 * gsd) << "the model's squares lie as the pixels do, not as the house";
    EXPECT_LT(fit.rmse, 0.1 * gsd);
    image.spread = 0.0;
    EXPECT_GT(fit_of_building(image, building_of(house())).mad, 4.0 * fit.mad);
  }
}

TEST(BuildingFit, AFlatBoxIsMeantExactlyAlongItsWalls) {
  Building box;
  box.status = BuildingStatus::kExtrusion;
  box.height = 5.0;
  box.outline = {{{-4.0, -3.0}, {4.0, -3.0}, {4.0, 3.0}, {-4.0, 3.0}}, {}};
  const House same = box_house(8.0, 6.0, flat_roof(5.0), 0.0);
  // Squares of three parts of a pixel, then of one and two thirds.
  for (const double spread : {1.0, 5.0 / 3.0}) {
    HeightImage image = image_of_means(same, spread, {.gsd = 1.0, .size = 16});
    for (auto& inside : image.inside) inside = 1;
    EXPECT_LT(fit_of_building(image, box).mad, 0.03) << spread;
  }
}

}  // namespace
}  // namespace gable
