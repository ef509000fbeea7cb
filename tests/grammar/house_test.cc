#include <gable/grammar/house.h>
#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

TEST(House, EveryFoundationIsFoundByItsName) {
  for (int i = 0; i < kNumFoundationTypes; ++i) {
    const auto type = static_cast<Foundation>(i);
    Foundation found = Foundation::kI;
    EXPECT_TRUE(foundation_from_name(foundation_name(type), &found));
    EXPECT_EQ(found, type);
  }
  EXPECT_EQ(foundation_name(Foundation::kMany), "N");
  Foundation unknown = Foundation::kI;
  EXPECT_FALSE(foundation_from_name("IV", &unknown));
}

TEST(House, AFreshOneIsWellFormedUnlessItIsNotInTheGrammar) {
  for (int i = 0; i < kNumFoundationTypes; ++i) {
    const auto type = static_cast<Foundation>(i);
    const House house = make_house(type);
    EXPECT_EQ(is_well_formed(house), type != Foundation::kC) << foundation_name(type);
    EXPECT_EQ(house.num_components(), num_components(type)) << foundation_name(type);
  }
}

TEST(House, ManyHasFourComponentsOrMoreAndTheOthersTheirOwnNumber) {
  const RoofedRectangle block{-2.0, 2.0, -2.0, 2.0, flat_roof(5.0)};
  for (int n = 1; n <= 9; ++n) {
    House house = blocks_house(std::vector<RoofedRectangle>(n, block), 0.0);
    for (int i = 0; i < kNumFoundationTypes; ++i) {
      house.foundation = static_cast<Foundation>(i);
      const bool fits = house.foundation == Foundation::kMany ? n >= 4 : n <= 3 && i == n - 1;
      EXPECT_EQ(is_well_formed(house), fits) << n << " " << foundation_name(house.foundation);
    }
  }
}

TEST(House, EveryComponentOfManyNeedsAFootprintOfItsOwn) {
  House house = make_house(Foundation::kMany);
  house.footprints.pop_back();
  EXPECT_FALSE(is_well_formed(house));
  house.roofs.push_back(house.roofs[0]);
  EXPECT_FALSE(is_well_formed(house));
}

}  // namespace
}  // namespace gable
