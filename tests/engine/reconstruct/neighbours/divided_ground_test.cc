#include <gable/engine/reconstruct/neighbours/divided_ground.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

PlanShape box(double x0, double y0, double x1, double y1) {
  return {{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}};
}

PlanLine line(const Eigen::Vector2d& normal, double offset) {
  PlanLine out;
  out.normal = normal.normalized();
  out.offset = offset;
  return out;
}

PlanLine turned(PlanLine cut) {
  cut.normal = -cut.normal;
  cut.offset = -cut.offset;
  return cut;
}

PlanShape both_of(const std::vector<PlanShape>& walls) { return common_of(walls[0], walls[1]); }

/// Divides where cuts do all of it.
std::vector<PlanShape> divided(const std::vector<PlanHouse>& houses) {
  return divided_ground(houses, [](size_t, const PlanPolygon&) { return 0.0; });
}

TEST(DividedGround, OfCommonGroundEachKeepsItsSideOfTheCut) {
  const PlanLine cut = line({1, 0}, 5.0);
  const auto walls = divided({{box(0, 0, 6, 8), {cut}}, {box(4.5, 1, 10, 9), {turned(cut)}}});
  EXPECT_NEAR(area_of(walls[0]), 48.0 - 7.0, 1e-9);
  EXPECT_NEAR(area_of(walls[1]), 44.0 - 3.5, 1e-9);
  EXPECT_TRUE(both_of(walls).empty());
}

TEST(DividedGround, NoGroundIsLost) {
  for (const double angle : {0.0, 0.3, 1.0}) {
    const PlanLine cut = line({std::cos(angle), std::sin(angle)}, 5.0);
    const PlanShape a = box(0, 0, 7, 8), b = box(4, 3, 12, 11);
    const auto walls = divided({{a, {cut}}, {b, {turned(cut)}}});
    EXPECT_NEAR(area_of(union_of(walls[0], walls[1])), area_of(union_of(a, b)), 1e-9);
    EXPECT_TRUE(both_of(walls).empty());
  }
}

TEST(DividedGround, WhatAHouseCoversAloneStaysItsOwnBeyondTheCut) {
  const PlanLine cut = line({1, 0}, 5.0);
  const auto walls = divided({{box(0, 0, 6, 8), {cut}}, {box(7, 0, 12, 8), {turned(cut)}}});
  EXPECT_NEAR(area_of(walls[0]), 48.0, 1e-9);
}

TEST(DividedGround, WithoutACutCommonGroundIsWhoseItWasSeenToBe) {
  const PlanLine cut = line({1, 0}, 5.0), other = line({1, 0}, 5.1);
  const std::vector<PlanHouse> houses = {{box(0, 0, 6, 8), {cut}},
                                         {box(4, 0, 10, 8), {turned(other)}}};
  for (const size_t owner : {0u, 1u}) {
    const auto walls = divided_ground(houses, [&](size_t house, const PlanPolygon& polygon) {
      EXPECT_NEAR(area_of({polygon}), 16.0, 1e-9);
      return house == owner ? 9.0 : 7.0;
    });
    EXPECT_NEAR(area_of(walls[owner]), 48.0, 1e-9);
    EXPECT_NEAR(area_of(walls[1 - owner]), 32.0, 1e-9);
  }
}

TEST(DividedGround, AHouseBetweenTwoIsCutOnBothSides) {
  const PlanLine first = line({1, 0}, 5.0), second = line({1, 0}, 10.0);
  const auto walls = divided({{box(0, 0, 5.5, 8), {first}},
                              {box(4.5, 0, 10.5, 8), {turned(first), second}},
                              {box(9.5, 0, 15, 8), {turned(second)}}});
  EXPECT_NEAR(area_of(walls[0]), 40.0, 1e-9);
  EXPECT_NEAR(area_of(walls[1]), 40.0, 1e-9);
  EXPECT_NEAR(area_of(walls[2]), 40.0, 1e-9);
}

}  // namespace
}  // namespace gable
