#include <gable/engine/error.h>
#include <gable/engine/reconstruct/annotate/annotated_from_answer.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/scratch.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

/// Crop x points north-east by 30 degrees, a pixel is half a metre.
HouseAnswer answer(Foundation foundation) {
  HouseAnswer answer;
  answer.id = "b7";
  answer.frame = {M_PI / 6.0, {1000.0, 2000.0}, 0.5};
  answer.foundation = foundation;
  answer.confidence = Confidence::kHigh;
  return answer;
}

HouseAnswer l_answer() {
  HouseAnswer l = answer(Foundation::kL);
  l.polygon = {{10.0, 10.0}, {50.0, 10.4}, {50.0, 30.0}, {30.0, 30.0}, {30.3, 50.0}, {10.0, 50.0}};
  l.roofs = {RoofType::kGable};
  return l;
}

/// A point of the crop in the world, in closed form.
Eigen::Vector2d world(double x, double y) {
  const double c = std::sqrt(0.75), s = 0.5;
  return {1000.0 + 0.5 * (c * x + s * y), 2000.0 + 0.5 * (s * x - c * y)};
}

std::string refusal(const HouseAnswer& answer) {
  return error_of([&] { annotated_from_answer(answer, "a.json"); }, "a.json: b7").what();
}

TEST(AnnotatedFromAnswer, RectanglesBecomeCornersInTheWorld) {
  HouseAnswer pair = answer(Foundation::kII);
  pair.rectangles = {{10.0, 20.0, 30.0, 40.0}, {30.0, 24.0, 50.0, 40.0}};
  pair.roofs = {RoofType::kGable, RoofType::kHip};
  pair.chimneys = {{12.0, 22.0}};
  pair.garages = {{{50.0, 24.0}, {58.0, 24.0}, {58.0, 30.0}}};
  const AnnotatedHouse house = annotated_from_answer(pair, "a.json");
  EXPECT_EQ(house.azimuth, M_PI / 6.0);
  ASSERT_EQ(house.components.size(), 2u);
  EXPECT_LT((house.components[1][0] - world(30.0, 24.0)).norm(), 1e-9);  // top left
  EXPECT_LT((house.components[1][1] - world(50.0, 24.0)).norm(), 1e-9);  // top right
  EXPECT_LT((house.components[1][2] - world(30.0, 40.0)).norm(), 1e-9);  // bottom left
  EXPECT_LT((house.components[1][3] - world(50.0, 40.0)).norm(), 1e-9);  // bottom right
  EXPECT_EQ(house.outline.size(), 6u);
  EXPECT_LT((house.center - world(30.0, 30.0)).norm(), 1e-9);
  EXPECT_LT((house.chimneys[0] - world(12.0, 22.0)).norm(), 1e-9);
  EXPECT_LT((house.garages[0][2] - world(58.0, 30.0)).norm(), 1e-9);
  EXPECT_EQ(house.roofs, pair.roofs);
}

TEST(AnnotatedFromAnswer, EdgesOfAnLArePulledStraight) {
  const AnnotatedHouse house = annotated_from_answer(l_answer(), "a.json");
  ASSERT_EQ(house.outline.size(), 6u);
  const double expected[6][2] = {{10.0, 10.2},  {50.0, 10.2},  {50.0, 30.0},
                                 {30.15, 30.0}, {30.15, 50.0}, {10.0, 50.0}};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_LT((house.outline[i] - world(expected[i][0], expected[i][1])).norm(), 1e-9) << i;
  }
}

TEST(AnnotatedFromAnswer, EitherWayAroundIsAnLOrAU) {
  HouseAnswer l = l_answer();
  std::reverse(l.polygon.begin(), l.polygon.end());
  EXPECT_EQ(annotated_from_answer(l, "a.json").outline.size(), 6u);
  HouseAnswer u = answer(Foundation::kU);
  u.polygon = {{10.0, 10.0}, {50.0, 10.0}, {50.0, 40.0}, {40.0, 40.0},
               {40.0, 20.0}, {20.0, 20.0}, {20.0, 50.0}, {10.0, 50.0}};
  u.roofs = {RoofType::kHip};
  for (size_t turn = 0; turn < 8; ++turn) {
    EXPECT_EQ(annotated_from_answer(u, "a.json").outline.size(), 8u) << turn;
    std::rotate(u.polygon.begin(), u.polygon.begin() + 1, u.polygon.end());
  }
}

TEST(AnnotatedFromAnswer, WhatMakesNoHouseIsRefusedInOneLine) {
  HouseAnswer one = answer(Foundation::kI);
  one.rectangles = {{10.0, 20.0, 30.0, 40.0}};
  one.roofs = {RoofType::kFlat};
  EXPECT_NO_THROW(annotated_from_answer(one, "a.json"));
  HouseAnswer bad = one;
  bad.confidence.reset();
  EXPECT_THAT(refusal(bad), HasSubstr("confidence"));
  bad = one;
  bad.rectangles = {{30.0, 20.0, 10.0, 40.0}};
  EXPECT_THAT(refusal(bad), HasSubstr("x0 < x1"));
  bad = one;
  bad.rectangles.push_back({30.0, 20.0, 40.0, 40.0});
  EXPECT_THAT(refusal(bad), HasSubstr("1 rectangles, not 2"));
  bad = one;
  bad.roofs.clear();
  EXPECT_THAT(refusal(bad), HasSubstr("1 roofs, not 0"));
  bad = one;
  bad.dormers = {{500.0, 20.0}};
  EXPECT_THAT(refusal(bad), HasSubstr("outside of the crop"));

  HouseAnswer pair = answer(Foundation::kII);
  pair.rectangles = {{10.0, 20.0, 30.0, 40.0}, {33.0, 20.0, 50.0, 40.0}};
  pair.roofs = {RoofType::kFlat, RoofType::kFlat};
  EXPECT_THAT(refusal(pair), HasSubstr("do not touch"));

  HouseAnswer slanted = l_answer();
  slanted.polygon[1] = {50.0, 14.0};
  EXPECT_THAT(refusal(slanted), HasSubstr("along x and y"));
  HouseAnswer five = l_answer();
  five.polygon.pop_back();
  EXPECT_THAT(refusal(five), HasSubstr("6 corners, not 5"));
  // Two concave corners on opposite sides are no U but an S.
  HouseAnswer s = answer(Foundation::kU);
  s.polygon = {{10.0, 10.0}, {40.0, 10.0}, {40.0, 20.0}, {50.0, 20.0},
               {50.0, 40.0}, {20.0, 40.0}, {20.0, 30.0}, {10.0, 30.0}};
  s.roofs = {RoofType::kGable};
  EXPECT_THAT(refusal(s), HasSubstr("no U"));
  HouseAnswer nothing = answer(Foundation::kC);
  EXPECT_THAT(refusal(nothing), HasSubstr("fewer than 3"));
}

TEST(AnnotatedFromAnswer, ComesBackThroughAFrameOfItsOwn) {
  HouseAnswer pair = answer(Foundation::kII);
  pair.rectangles = {{10.0, 20.0, 30.0, 40.0}, {30.0, 24.0, 50.0, 40.0}};
  pair.roofs = {RoofType::kGable, RoofType::kHip};
  pair.dormers = {{25.0, 30.0}};
  const AnnotatedHouse house = annotated_from_answer(pair, "a.json");
  const HouseAnswer back = answer_from_annotated(house);
  ASSERT_EQ(back.rectangles.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const CropRectangle& r = back.rectangles[i];
    EXPECT_LT((back.frame.world_from_crop({r.x0, r.y0}) - house.components[i][0]).norm(), 1e-9);
    EXPECT_LT((back.frame.world_from_crop({r.x1, r.y1}) - house.components[i][3]).norm(), 1e-9);
  }
  EXPECT_LT((back.frame.world_from_crop(back.dormers[0]) - house.dormers[0]).norm(), 1e-9);
  // The outline's box is in the middle, with a fifth of its longer side around.
  double low = 64.0, high = 0.0;
  for (const Eigen::Vector2d& p : back.polygon) {
    low = std::min(low, p.x());
    high = std::max(high, p.x());
  }
  EXPECT_NEAR(low, 64.0 * 0.2 / 1.4, 1e-9);
  EXPECT_NEAR(high, 64.0 * 1.2 / 1.4, 1e-9);
}

}  // namespace
}  // namespace gable
