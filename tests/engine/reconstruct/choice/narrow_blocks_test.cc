#include <gable/engine/reconstruct/choice/narrow_blocks.h>
#include <gtest/gtest.h>

#include "engine/house_image.h"

namespace gable {
namespace {

/// A hip roof of 12 x 8 m in the middle of a lower one that is `wider` metres wider on every side.
House shell(double wider) {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = 0.3;
  house.footprints = {rectangle_rule(-6.0, 6.0, -4.0, 4.0),
                      rectangle_rule(-6.0 - wider, 6.0 + wider, -4.0 - wider, 4.0 + wider)};
  house.roofs = {hip_roof(6.0, 3.0, 0.3, 0.3, Axis::kX), hip_roof(3.0, 2.0, 0.3, 0.3, Axis::kX)};
  return house;
}

TEST(NarrowBlocks, AShellOfOnePixelAroundABlockIsOne) {
  EXPECT_EQ(count_narrow_blocks(image_of(shell(0.5)), shell(0.5)), 1);
  EXPECT_EQ(count_narrow_blocks(image_of(shell(0.5), {.gsd = 1.0}), shell(0.5)), 1);
}

TEST(NarrowBlocks, ATerraceOfFourPixelsAroundABlockIsNone) {
  EXPECT_EQ(count_narrow_blocks(image_of(shell(2.0)), shell(2.0)), 0);
  // On pixels of 2 m it is one pixel wide.
  EXPECT_EQ(count_narrow_blocks(image_of(shell(2.0), {.gsd = 2.0}), shell(2.0)), 1);
}

TEST(NarrowBlocks, ABlockThatOthersHideIsOne) {
  House house = shell(0.0);
  house.footprints[1] = rectangle_rule(-5.0, 5.0, -3.0, 3.0);
  EXPECT_EQ(count_narrow_blocks(image_of(house), house), 1);
}

TEST(NarrowBlocks, WingsAreNoneAndDormersHideNothing) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 7.0, -3.0, 3.0)};
  house.roofs = {gable_roof(5.0, 2.5, Axis::kX), gable_roof(4.0, 2.5, Axis::kX)};
  for (const double x : {3.0, 4.5, 6.0}) {
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = 1;
    dormer.values = {x, -1.5, 1.4, 2.8, 5.6, 0.6};
    house.dormers.push_back(dormer);
  }
  EXPECT_EQ(count_narrow_blocks(image_of(house), house), 0);
}

TEST(NarrowBlocks, AnAnnexBesideABlockIsNoneHoweverNarrow) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 3.0, -3.0, 3.0)};
  house.roofs = {gable_roof(5.0, 2.5, Axis::kX), flat_roof(3.0)};
  EXPECT_EQ(count_narrow_blocks(image_of(house), house), 0);
}

TEST(NarrowBlocks, AHouseOfOneComponentHasNoneHoweverNarrow) {
  const House house = box_house(10.0, 1.0, flat_roof(3.0));
  EXPECT_EQ(count_narrow_blocks(image_of(house), house), 0);
}

}  // namespace
}  // namespace gable
