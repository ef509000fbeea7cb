#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/houses/roof_clutter.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

TEST(RoofClutter, LiftsStandOnTheRoofAndAreLow) {
  Random random(1);
  size_t made = 0;
  for (int i = 0; i < 200; ++i) {
    House house = random_house(&random);
    house.origin = {400.0, 200.0, 70.0};
    const BuiltShape bare = shape_of(house);
    BuiltShape shape = bare;
    add_roof_clutter(house, &random, &shape);
    for (const BuiltPart& lift : shape.lifts) {
      ++made;
      EXPECT_GT(lift.eaves, 0.0);
      EXPECT_LE(lift.eaves, 1.2);
      EXPECT_TRUE(std::isfinite(bare.at(lift.center)));
    }
  }
  EXPECT_GT(made, 100u);
}

TEST(RoofClutter, PlanGrowsByAnOverhangAndABayAtMost) {
  Random random(2);
  int hanging = 0, with_bay = 0;
  for (int i = 0; i < 200; ++i) {
    House house = random_house(&random);
    house.origin = {400.0, 200.0, 70.0};
    const BuiltShape bare = shape_of(house);
    BuiltShape shape = bare;
    add_roof_clutter(house, &random, &shape);
    ASSERT_LE(shape.parts.size(), bare.parts.size() + 1);
    for (size_t p = 0; p < bare.parts.size(); ++p) {
      const double grown = shape.parts[p].half_width - bare.parts[p].half_width;
      EXPECT_GE(grown, 0.0);
      EXPECT_LE(grown, 0.3);
      hanging += p == 0 && grown > 0.0;
      // The ridge stays where it is.
      EXPECT_NEAR(shape.parts[p].eaves + shape.parts[p].rise,
                  bare.parts[p].eaves + bare.parts[p].rise, 1e-9);
    }
    if (shape.parts.size() == bare.parts.size()) continue;
    ++with_bay;
    const BuiltPart& bay = shape.parts.back();
    EXPECT_LT(ring_distance(bay.ring(), bare.parts[0].ring()), 1e-9);
    EXPECT_LE(bay.eaves, bare.parts[0].eaves + 1e-9);
    EXPECT_LE(std::min(bay.half_length, bay.half_width), 0.45);
  }
  EXPECT_GT(hanging, 40);
  EXPECT_GT(with_bay, 30);
}

TEST(RoofClutter, PlanesKeepTheirPlaceUnderAnOverhang) {
  // A gable roof that hangs over has the same heights over the house.
  Random random(3);
  House house = make_house(Foundation::kI);
  house.origin = {400.0, 200.0, 70.0};
  const BuiltShape bare = shape_of(house);
  for (int i = 0; i < 50; ++i) {
    BuiltShape shape = bare;
    add_roof_clutter(house, &random, &shape);
    shape.lifts.clear();
    for (int k = 0; k < 50; ++k) {
      const Eigen::Vector2d p(random.uniform(395.5, 404.5), random.uniform(196.5, 203.5));
      EXPECT_NEAR(shape.at(p), bare.at(p), 1e-9);
    }
  }
}

}  // namespace
}  // namespace gable
