#include <gable/grammar/synthesis/houses/flat_parts.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

Rule footprint(double x0, double x1, double y0, double y1) {
  using namespace param::rectangle;
  Rule rule = make_rule(RuleKind::kFootprintI);
  rule[kCenterX] = 0.5 * (x0 + x1);
  rule[kCenterY] = 0.5 * (y0 + y1);
  rule[kLength] = x1 - x0;
  rule[kWidth] = y1 - y0;
  return rule;
}

/// A gable of 5 x 8 m, eaves 5, ridge at 8 m, with a flat part behind it.
House shelved(double depth, double height) {
  House house;
  house.foundation = Foundation::kII;
  Rule gable = make_rule(RuleKind::kRoofGable);
  gable.ridge = Axis::kX;
  gable[param::roof::kEaves] = 5.0;
  gable[param::roof::kRise] = 3.0;
  house.footprints = {footprint(0.0, 5.0, 0.0, 8.0), footprint(0.0, 5.0, 8.0, 8.0 + depth)};
  house.roofs = {gable, make_flat_roof(height)};
  return house;
}

TEST(FlatParts, ShelfAsHighAsTheEavesIsDistinct) {
  EXPECT_TRUE(flat_parts_are_distinct(shelved(2.0, 5.0)));
}

TEST(FlatParts, ShelfMustShowEightSquareMetres) {
  EXPECT_TRUE(flat_parts_are_distinct(shelved(1.61, 5.0)));
  EXPECT_FALSE(flat_parts_are_distinct(shelved(1.59, 5.0)));
}

TEST(FlatParts, LowerThanAGarageOrAsHighAsTheRidgeIsNot) {
  EXPECT_TRUE(flat_parts_are_distinct(shelved(3.0, 3.8)));
  EXPECT_FALSE(flat_parts_are_distinct(shelved(3.0, 3.7)));
  EXPECT_TRUE(flat_parts_are_distinct(shelved(3.0, 7.0)));
  EXPECT_FALSE(flat_parts_are_distinct(shelved(3.0, 7.1)));
}

TEST(FlatParts, PartUnderTheFirstShowsWhatReachesBeyondIt) {
  House house = shelved(2.0, 4.5);
  house.footprints[1] = footprint(0.0, 5.0, 6.0, 9.0);  // 5 m2 beyond
  EXPECT_FALSE(flat_parts_are_distinct(house));
  house.footprints[1] = footprint(0.0, 5.0, 6.0, 10.0);
  EXPECT_TRUE(flat_parts_are_distinct(house));
}

TEST(FlatParts, PitchedLaterPartIsNone) {
  House house = shelved(4.0, 5.0);
  house.roofs[1] = house.roofs[0];
  EXPECT_FALSE(flat_parts_are_distinct(house));
}

TEST(FlatParts, TwoFlatPartsDifferInHeight) {
  House house = shelved(3.0, 5.0);
  house.foundation = Foundation::kIII;
  house.footprints.push_back(footprint(0.0, 5.0, 11.0, 14.0));
  house.roofs.push_back(make_flat_roof(4.0));
  EXPECT_TRUE(flat_parts_are_distinct(house));
  house.roofs[2] = make_flat_roof(4.1);
  EXPECT_FALSE(flat_parts_are_distinct(house));
}

}  // namespace
}  // namespace gable
