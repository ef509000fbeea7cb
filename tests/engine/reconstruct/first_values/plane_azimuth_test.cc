#include <gable/engine/reconstruct/first_values/plane_azimuth.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

// A plane that falls in `direction` with `slope`.
HousePlane plane_of(double direction, double slope, int pixels) {
  HousePlane plane;
  plane.plane = {-slope * std::cos(direction), -slope * std::sin(direction), 5.0};
  plane.pixels.resize(pixels);
  return plane;
}

TEST(PlaneAzimuth, IsTheDirectionOfPlanesModuloAQuarterTurn) {
  HouseScale scale;
  for (const double turn : {0.0, 0.5, 1.0, 1.5}) {
    scale.planes.push_back(plane_of(0.3 + turn * M_PI, 0.7, 100));
  }
  const auto azimuth = plane_azimuth(scale);
  ASSERT_TRUE(azimuth);
  EXPECT_NEAR(azimuth->azimuth, 0.3, 1e-9);
  EXPECT_NEAR(azimuth->strength, 1.0, 1e-9);
  EXPECT_EQ(azimuth->planes, 4);
}

TEST(PlaneAzimuth, PlanesOfSomethingElseDoNotTurnIt) {
  HouseScale scale;
  scale.planes = {plane_of(0.3, 0.7, 100), plane_of(0.3 + M_PI, 0.7, 90), plane_of(0.8, 0.7, 20),
                  plane_of(1.0, 0.02, 500)};
  const auto azimuth = plane_azimuth(scale);
  ASSERT_TRUE(azimuth);
  EXPECT_NEAR(azimuth->azimuth, 0.3, 1e-9);
  EXPECT_EQ(azimuth->planes, 2);
}

TEST(PlaneAzimuth, LevelPlanesAndDirectionsThatDisagreeHaveNone) {
  HouseScale scale;
  EXPECT_FALSE(plane_azimuth(scale));
  scale.planes = {plane_of(0.3, 0.05, 100)};
  EXPECT_FALSE(plane_azimuth(scale));
  scale.planes = {plane_of(0.0, 0.7, 100), plane_of(0.25 * M_PI, 0.7, 100)};
  EXPECT_FALSE(plane_azimuth(scale));
}

}  // namespace
}  // namespace gable
