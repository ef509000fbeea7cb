#include <gable/grammar/synthesis/houses/visible_hips.h>
#include <gtest/gtest.h>

#include <limits>

namespace gable {
namespace {

/// 10 m along a ridge whose hips run over 1 and 3 m.
House hipped() {
  House house = make_house(Foundation::kI);
  using namespace param::rectangle;
  house.footprints[0][kLength] = 10.0;
  house.footprints[0][kWidth] = 7.0;
  house.roofs[0] = make_rule(RuleKind::kRoofHip);
  house.roofs[0].ridge = Axis::kX;
  house.roofs[0][param::roof::kEaves] = 4.0;
  house.roofs[0][param::roof::kRise] = 2.5;
  house.roofs[0][param::roof::kHipStart] = 0.1;
  house.roofs[0][param::roof::kHipEnd] = 0.3;
  return house;
}

TEST(VisibleHips, LongHipsStayAndShortOnesGo) {
  House house = hipped();
  drop_short_hips(0.9, &house);
  EXPECT_EQ(house.roofs[0][param::roof::kHipStart], 0.1);
  drop_short_hips(1.2, &house);
  ASSERT_EQ(house.roofs[0].kind, RuleKind::kRoofHip);
  EXPECT_EQ(house.roofs[0][param::roof::kHipStart], 0.0);
  EXPECT_EQ(house.roofs[0][param::roof::kHipEnd], 0.3);
}

TEST(VisibleHips, WithoutHipsTheRoofIsAGable) {
  House house = hipped();
  drop_short_hips(std::numeric_limits<double>::infinity(), &house);
  ASSERT_EQ(house.roofs[0].kind, RuleKind::kRoofGable);
  EXPECT_EQ(house.roofs[0].ridge, Axis::kX);
  EXPECT_EQ(house.roofs[0][param::roof::kEaves], 4.0);
  EXPECT_EQ(house.roofs[0][param::roof::kRise], 2.5);
  EXPECT_TRUE(is_well_formed(house));
}

}  // namespace
}  // namespace gable
