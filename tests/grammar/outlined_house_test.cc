#include <gable/grammar/outline_margins.h>
#include <gable/grammar/outlined_house.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace gable {
namespace {

// 10 x 6 m around the origin, ridge along x, eaves 3 m, ridge 6 m: sides rise 1 m per metre.
House gable_house(double azimuth) {
  House house = make_house(Foundation::kI);
  house.azimuth[0] = azimuth;
  house.footprints[0].values = {0.0, 0.0, 10.0, 6.0};
  house.roofs[0] = make_rule(RuleKind::kRoofGable);
  house.roofs[0].ridge = Axis::kX;
  house.roofs[0][param::roof::kEaves] = 3.0;
  house.roofs[0][param::roof::kRise] = 3.0;
  return house;
}

PlanPolygon rectangle(double x0, double x1, double y0, double y1, double azimuth) {
  const Eigen::Rotation2Dd local_from_house(azimuth);
  PlanPolygon polygon;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y0),
                                   Eigen::Vector2d(x1, y1), Eigen::Vector2d(x0, y1)}) {
    polygon.outer.push_back(local_from_house * p);
  }
  return polygon;
}

TEST(OutlinedHouse, EndsAtTheOutlineAndContinuesItsRoofToIt) {
  constexpr double kAzimuth = 0.3;
  const Eigen::Rotation2Dd local_from_house(kAzimuth);
  const OutlinedHouse house(gable_house(kAzimuth),
                            {rectangle(-4.0, 5.4, -3.3, 3.0, kAzimuth), 0.5});
  const auto at = [&](double x, double y) {
    return house.at_local(local_from_house * Eigen::Vector2d(x, y));
  };
  EXPECT_FALSE(at(-4.5, 0.0)) << "inside the rectangle, outside the outline";
  EXPECT_NEAR(at(-3.5, 1.0)->height, 5.0, 1e-12);
  EXPECT_NEAR(at(5.2, 0.0)->height, 6.0, 1e-12) << "the ridge goes on over the gable wall";
  EXPECT_NEAR(at(1.0, -3.2)->height, 2.8, 1e-12) << "the side goes on beyond the eaves";
  EXPECT_FALSE(at(1.0, 3.2));
}

TEST(OutlinedHouse, FillsNoFartherThanItsReach) {
  const PlanPolygon wide = rectangle(-5.0, 9.5, -3.0, 3.0, 0.0);
  for (const double reach : kOutlineMargins) {
    const OutlinedHouse house(gable_house(0.0), {wide, reach});
    EXPECT_TRUE(house.at_local({5.0 + reach - 0.01, 0.0}));
    EXPECT_FALSE(house.at_local({5.0 + reach + 0.01, 0.0}));
  }
}

TEST(OutlinedHouse, ABlockGivesWayToThoseThatStandThere) {
  House house = make_house(Foundation::kII);
  house.footprints[0].values = {0.0, 0.0, 10.0, 6.0};
  house.footprints[1].values = {7.0, 0.0, 4.0, 6.0};  // 5 to 9, beside it
  for (Rule& roof : house.roofs) roof = make_rule(RuleKind::kRoofFlat);
  house.roofs[0][param::roof::kEaves] = 6.0;
  house.roofs[1][param::roof::kEaves] = 3.0;
  const OutlinedHouse outlined(house, {rectangle(-6.0, 10.0, -4.0, 4.0, 0.0), 1.5});
  EXPECT_NEAR(outlined.at_local({5.2, 0.0})->height, 3.0, 1e-12);
  EXPECT_EQ(outlined.at_local({5.2, 0.0})->block, 1);
  EXPECT_NEAR(outlined.at_local({-5.5, 0.0})->height, 6.0, 1e-12);
  EXPECT_NEAR(outlined.at_local({9.5, 0.0})->height, 3.0, 1e-12);
  EXPECT_NEAR(outlined.at_local({5.3, 3.4})->height, 6.0, 1e-12)
      << "where both reach, the higher one is seen";
}

TEST(OutlinedHouse, WithoutAnOutlineItIsTheHeightField) {
  const House plain = gable_house(-0.7);
  const OutlinedHouse house(plain, {});
  const HeightField field(plain);
  for (double x = -6.0; x < 6.0; x += 0.37) {
    for (double y = -6.0; y < 6.0; y += 0.41) {
      const auto seen = house.at_local({x, y});
      EXPECT_NEAR(seen ? seen->height : 0.0, field.at_local({x, y}, 0.0, 0.0), 1e-12);
    }
  }
}

TEST(ContinuedRoof, IsTheRoofInsideAndLinearBeyondIt) {
  House house = gable_house(0.0);
  house.roofs[0].kind = RuleKind::kRoofHip;
  house.roofs[0][param::roof::kHipStart] = 0.3;  // 3 m run: 1 m per metre
  house.roofs[0][param::roof::kHipEnd] = 0.0;
  const Block<double> block = expand_blocks(house)[0];
  for (double x = -4.9; x < 5.0; x += 0.3) {
    for (double y = -2.9; y < 3.0; y += 0.3) {
      EXPECT_NEAR(continued_roof_height(block, {x, y}), roof_height(block, x, y), 1e-12);
    }
  }
  EXPECT_NEAR(continued_roof_height(block, {-6.0, 0.0}), 2.0, 1e-12);
  EXPECT_NEAR(continued_roof_height(block, {8.0, 0.0}), 6.0, 1e-12);
  EXPECT_NEAR(continued_roof_height(block, {0.0, 4.0}), 2.0, 1e-12);
}

}  // namespace
}  // namespace gable
