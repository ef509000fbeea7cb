#include <gable/grammar/block.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/box_dormers.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// 9 x 9 m under a gable with its ridge along x.
House gabled(double slope) {
  House house = make_house(Foundation::kI);
  using namespace param::rectangle;
  house.footprints[0][kCenterX] = house.footprints[0][kCenterY] = 0.0;
  house.footprints[0][kLength] = house.footprints[0][kWidth] = 9.0;
  house.roofs[0] = make_rule(RuleKind::kRoofGable);
  house.roofs[0].ridge = Axis::kX;
  house.roofs[0][param::roof::kEaves] = 5.0;
  house.roofs[0][param::roof::kRise] = 4.5 * slope;
  return house;
}

TEST(BoxDormers, AreFlatTwoToFourMetresWideAndStandOut) {
  Random random(1);
  int found = 0;
  double widest = 0.0;
  for (int i = 0; i < 200; ++i) {
    House house = gabled(random.uniform(0.6, 1.2));
    const HeightField bare(house);
    add_box_dormers(&random, &house);
    const HeightField field(house);
    namespace d = param::dormer;
    for (const Rule& dormer : house.dormers) {
      ++found;
      widest = std::max(widest, dormer[d::kWidth]);
      EXPECT_EQ(dormer[d::kRise], 0.0);
      EXPECT_GE(dormer[d::kWidth], 2.0);
      EXPECT_LE(dormer[d::kWidth], 4.0);
      EXPECT_GE(dormer[d::kDepth], 1.2);
      EXPECT_LE(dormer[d::kDepth], 4.2);
      // Out of the slope in front, into it at the back, below the ridge.
      const double sign = dormer[d::kCenterY] < 0.0 ? 1.0 : -1.0;
      const auto at = [&](double share) {
        return Eigen::Vector2d(dormer[d::kCenterX],
                               dormer[d::kCenterY] + sign * share * dormer[d::kDepth]);
      };
      EXPECT_GE(dormer[d::kEaves] - bare.at_house(at(-0.5), 0.0, 0.0), 1.0 - 1e-6);
      EXPECT_NEAR(dormer[d::kEaves], bare.at_house(at(0.5), 0.0, 0.0), 1e-6);
      EXPECT_NEAR(field.at_house(at(0.0), 0.0, 0.0), dormer[d::kEaves], 1e-6);
    }
  }
  EXPECT_GT(found, 150);
  EXPECT_GT(widest, 3.5);
}

TEST(BoxDormers, NoneOnShallowOrFlatRoofs) {
  Random random(2);
  House shallow = gabled(0.5);
  add_box_dormers(&random, &shallow);
  EXPECT_TRUE(shallow.dormers.empty());
  House flat = gabled(0.8);
  flat.roofs[0] = make_rule(RuleKind::kRoofFlat);
  add_box_dormers(&random, &flat);
  EXPECT_TRUE(flat.dormers.empty());
}

}  // namespace
}  // namespace gable
