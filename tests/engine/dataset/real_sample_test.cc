#include <gable/engine/dataset/real_sample.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

/// A building whose house fits its heights exactly, 20 ahead of an L.
TileBuilding sure_building() {
  TileBuilding building;
  House house = make_house(Foundation::kI);
  HeightImage& image = building.image;
  image.gsd = 0.5;
  image.rows = image.cols = 60;
  image.first_center = {-14.75, 14.75};
  const HeightField field(house);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const double height = field.at_local(image.center_of(row, col), 0.0, 0.0);
      image.height.push_back(static_cast<float>(height));
      image.ground.push_back(0.0f);
      image.weight.push_back(1.0f);
      image.inside.push_back(height > 0.0);
    }
  }
  building.building.house = house;
  building.building.quality.mad = 0.1;
  building.choice.found = true;
  building.choice.best.house = house;
  building.choice.best.cost.total = 100.0;
  Candidate other;
  other.house = make_house(Foundation::kL);
  other.cost.total = 120.0;
  building.choice.finalists = {building.choice.best, other};
  return building;
}

TEST(RealSample, AHouseThatFitsAndIsFarAheadTeachesItsOwnAnswer) {
  const TileBuilding building = sure_building();
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kHouse);
  const auto sample = real_sample(building, {});
  ASSERT_TRUE(sample.has_value());
  EXPECT_EQ(sample->foundation, Foundation::kI);
  EXPECT_EQ(sample->corners.size(), 4u);
  EXPECT_FALSE(sample->details_known);
}

TEST(RealSample, WhatHasMoreThanThreeBlocksIsCToTheDetectors) {
  TileBuilding building = sure_building();
  const RoofedRectangle half{-6.0, 0.0, -4.0, 4.0, make_rule(RuleKind::kRoofGable)};
  building.building.house = blocks_house({half, half, half, half}, 0.0);
  building.choice.best.house = *building.building.house;
  building.choice.finalists[0] = building.choice.best;
  RealSampleOptions options;
  options.least_iou = 0.0;
  building.choice.foundation = {0.1f, 0.0f, 0.1f, 0.0f, 0.0f, 0.8f};
  EXPECT_EQ(judge(building, options), RealSampleVerdict::kBeyondGrammar);
  const auto sample = real_sample(building, options);
  ASSERT_TRUE(sample.has_value());
  EXPECT_EQ(sample->foundation, Foundation::kC);
  building.choice.foundation = {0.1f, 0.0f, 0.8f, 0.0f, 0.0f, 0.1f};
  EXPECT_EQ(judge(building, options), RealSampleVerdict::kCloseSecond);
}

TEST(RealSample, TheLeadIsOverTheBestOfAnotherType) {
  TileBuilding building = sure_building();
  EXPECT_DOUBLE_EQ(lead_of(building.choice), 20.0);
  Candidate same = building.choice.best;
  same.cost.total = 101.0;
  building.choice.finalists.push_back(same);
  EXPECT_DOUBLE_EQ(lead_of(building.choice), 20.0);
  building.choice.finalists.erase(building.choice.finalists.begin() + 1);
  EXPECT_EQ(lead_of(building.choice), std::numeric_limits<double>::infinity());
  building.choice.found = false;
  EXPECT_EQ(lead_of(building.choice), 0.0);
}

TEST(RealSample, ACloseSecondOfAnotherTypeDoesNotTeach) {
  TileBuilding building = sure_building();
  building.choice.finalists[1].cost.total = 101.0;
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kCloseSecond);
  EXPECT_FALSE(real_sample(building, {}).has_value());
}

TEST(RealSample, ATypeThatTheDetectorsDoubtDoesNotTeach) {
  TileBuilding building = sure_building();
  building.choice.foundation = {0.6f, 0.4f, 0.0f, 0.0f, 0.0f, 0.0f};
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kCloseSecond);
  building.choice.foundation = {0.8f, 0.2f, 0.0f, 0.0f, 0.0f, 0.0f};
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kHouse);
}

TEST(RealSample, APoorFitDoesNotTeach) {
  TileBuilding building = sure_building();
  building.building.quality.mad = 0.6;
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kPoorFit);
}

TEST(RealSample, AnOutlineOffTheBuildingsPixelsDoesNotTeach) {
  TileBuilding building = sure_building();
  EXPECT_GT(outline_iou(building), 0.99);
  building.building.house->footprints[0][0] += 4.0;
  EXPECT_LT(outline_iou(building), 0.65);
  EXPECT_EQ(judge(building, {}), RealSampleVerdict::kPoorFit);
}

TEST(RealSample, WhatNothingFitsIsClassCOnlyWhereItIsLarge) {
  TileBuilding building = sure_building();
  building.building.status = BuildingStatus::kExtrusion;
  building.building.house.reset();
  RealSampleOptions options;
  options.beyond_area = 1000.0;
  EXPECT_EQ(judge(building, options), RealSampleVerdict::kPoorFit);
  options.beyond_area = 10.0;
  EXPECT_EQ(judge(building, options), RealSampleVerdict::kBeyondGrammar);
  const auto sample = real_sample(building, options);
  ASSERT_TRUE(sample.has_value());
  EXPECT_EQ(sample->foundation, Foundation::kC);
  EXPECT_TRUE(std::isnan(sample->azimuth));
}

TEST(RealSampleOptions, ChecksNameTheBound) {
  RealSampleOptions options;
  EXPECT_EQ(check(options), "");
  options.beyond_mad = 0.1;
  EXPECT_NE(check(options).find("beyond_mad"), std::string::npos);
  options = {};
  options.least_probability = 2.0;
  EXPECT_NE(check(options).find("least_probability"), std::string::npos);
}

}  // namespace
}  // namespace gable
