#include <gable/engine/reconstruct/annotate/annotated_from_answer.h>
#include <gable/engine/reconstruct/annotate/proposed_answer.h>
#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kAzimuth = 0.4 + M_PI;  // the frame's is the same modulo a quarter turn

House two_blocks() {
  House house = make_house(Foundation::kII);
  house.origin = {5000.0, 7000.0, 30.0};
  house.azimuth[0] = kAzimuth;
  house.footprints = {rectangle_rule(-9.0, 0.0, -4.0, 4.0), rectangle_rule(0.0, 8.0, -3.0, 4.0)};
  house.roofs = {gable_roof(5.0, 3.0, Axis::kX), hip_roof(4.0, 2.0, 0.2, 0.2, Axis::kX)};
  return house;
}

Eigen::Vector2d world(const House& house, double x, double y) {
  return house.origin.head<2>() + Eigen::Rotation2Dd(kAzimuth) * Eigen::Vector2d(x, y);
}

HouseAnswer proposal_of(const House& house) {
  Building building;
  building.id = "b";
  building.house = house;
  building.origin = house.origin;
  return proposed_answer(building, image_of(house));
}

double nearest(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& p) {
  double least = 1e9;
  for (const Eigen::Vector2d& q : points) least = std::min(least, (p - q).norm());
  return least;
}

TEST(ProposedAnswer, OfFourBlocksIsTheirOutlineAsTypeC) {
  const RoofedRectangle main{-6.0, 6.0, -4.0, 4.0, gable_roof(5.0, 3.0, Axis::kX)};
  const HouseAnswer answer = proposal_of(blocks_house({main,
                                                       {-3.0, 3.0, 4.0, 9.0, flat_roof(4.0)},
                                                       {6.0, 10.0, -2.0, 2.0, flat_roof(4.0)},
                                                       {-10.0, -6.0, -2.0, 2.0, flat_roof(4.0)}},
                                                      kAzimuth));
  EXPECT_EQ(answer.proposed, "C");
  EXPECT_TRUE(answer.rectangles.empty());
  EXPECT_TRUE(answer.roofs.empty());
  EXPECT_GE(answer.polygon.size(), 16u);
}

TEST(ProposedAnswer, IsTheHouseWhereItStands) {
  const House house = two_blocks();
  HouseAnswer answer = proposal_of(house);
  EXPECT_EQ(answer.proposed, "II");
  EXPECT_FALSE(answer.reviewed);
  EXPECT_FALSE(answer.confidence.has_value());
  EXPECT_EQ(answer.roofs, (std::vector<RoofType>{RoofType::kGable, RoofType::kHip}));
  EXPECT_NEAR(answer.frame.azimuth, 0.4, 1e-9);
  for (const CropRectangle& r : answer.rectangles) {
    EXPECT_GT(std::min(r.x0, r.y0), 5.0);  // in the middle of its crop
    EXPECT_LT(std::max(r.x1, r.y1), 59.0);
  }
  answer.confidence = Confidence::kHigh;
  const AnnotatedHouse annotated = annotated_from_answer(answer, "a.json");
  const double corners[2][4] = {{-9.0, 0.0, -4.0, 4.0}, {0.0, 8.0, -3.0, 4.0}};
  for (int i = 0; i < 2; ++i) {
    const std::vector<Eigen::Vector2d> got(annotated.components[i].begin(),
                                           annotated.components[i].end());
    for (const double x : {corners[i][0], corners[i][1]}) {
      for (const double y : {corners[i][2], corners[i][3]}) {
        EXPECT_LT(nearest(got, world(house, x, y)), 1e-6);
      }
    }
  }
}

TEST(ProposedAnswer, AnLIsItsPolygonWithOneRoof) {
  House house = make_house(Foundation::kL);
  house.origin = {5000.0, 7000.0, 30.0};
  house.azimuth[0] = kAzimuth;
  house.footprints[0].values = {-6.0, -6.0, 14.0, 6.0, 12.0, 7.0};
  house.roofs = {gable_roof(5.0, 3.0, Axis::kX), gable_roof(5.0, 3.0, Axis::kY)};
  HouseAnswer answer = proposal_of(house);
  EXPECT_TRUE(answer.rectangles.empty());
  EXPECT_EQ(answer.roofs, std::vector<RoofType>{RoofType::kGable});
  answer.confidence = Confidence::kHigh;
  const AnnotatedHouse annotated = annotated_from_answer(answer, "a.json");
  ASSERT_EQ(annotated.outline.size(), 6u);
  EXPECT_LT(nearest(annotated.outline, world(house, -6.0, -6.0)), 1e-6);
  EXPECT_LT(nearest(annotated.outline, world(house, 1.0, 0.0)), 1e-6);  // the concave corner
  EXPECT_LT(nearest(annotated.outline, world(house, 8.0, 0.0)), 1e-6);
}

TEST(ProposedAnswer, AnExtrusionIsItsOutline) {
  const House house = two_blocks();
  Building building;
  building.id = "b";
  building.status = BuildingStatus::kExtrusion;
  building.origin = house.origin;
  building.outline.outer = {{-9.0, -4.0}, {9.0, -4.0}, {0.0, 9.0}};
  HouseAnswer answer = proposed_answer(building, image_of(house));
  EXPECT_EQ(answer.proposed, "C");
  answer.confidence = Confidence::kLow;
  const AnnotatedHouse annotated = annotated_from_answer(answer, "a.json");
  EXPECT_LT((annotated.outline[2] - Eigen::Vector2d(5000.0, 7009.0)).norm(), 1e-6);
}

}  // namespace
}  // namespace gable
