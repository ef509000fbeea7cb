#include <gable/engine/reconstruct/first_values/classical_values.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

TEST(ClassicalValues, OneOfThemIsNearlyTheHouse) {
  const House house = box_house(14.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  const std::vector<FirstValue> values = classical_values(image_of(house), 2);
  ASSERT_FALSE(values.empty());
  double nearest = 100.0;
  for (const FirstValue& value : values) {
    EXPECT_EQ(value.source, ValueSource::kClassical);
    EXPECT_EQ(value.house.origin, house.origin);
    House copy = value.house;
    EXPECT_EQ(value.origins.size(), copy.derivation().size());
    if (value.house.foundation != Foundation::kI) continue;
    // The azimuth modulo a quarter turn; the area whatever the axes are called.
    const double turn = std::remainder(value.house.azimuth[0] - 0.3, 0.5 * M_PI);
    const Rule& f = value.house.footprints[0];
    nearest = std::min(nearest, std::abs(turn) + std::abs(f[2] * f[3] - 112.0) / 112.0);
  }
  EXPECT_LT(nearest, 0.15);
}

}  // namespace
}  // namespace gable
