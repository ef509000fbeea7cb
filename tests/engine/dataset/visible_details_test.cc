#include <gable/engine/dataset/visible_details.h>
#include <gable/grammar/synthesis/survey/lidar.h>
#include <gtest/gtest.h>

#include <limits>

namespace gable {
namespace {

/// A house with one chimney on its ridge, surveyed without noise at 0.25 m.
TrainingScene chimney_scene(double rise) {
  TrainingScene scene;
  scene.foundation = Foundation::kI;
  scene.house = make_house(Foundation::kI);
  const Rule& roof = scene.house.roofs[0];
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney[param::chimney::kCenterX] = scene.house.footprints[0][0];
  chimney[param::chimney::kCenterY] = scene.house.footprints[0][1];
  chimney[param::chimney::kSide] = 0.8;
  chimney[param::chimney::kHeight] = roof[param::roof::kEaves] + roof[param::roof::kRise] + rise;
  scene.house.chimneys = {chimney};
  Grid grid;
  grid.gsd = 0.25;
  grid.rows = grid.cols = 160;
  grid.north_west = {-20.0, 20.0};
  scene.dtm = HeightRaster(grid, 0.0f);
  scene.dsm = scene.dtm;
  scene.truth = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  rasterise_house(scene.house, &scene.dsm, &scene.truth);
  return scene;
}

TEST(VisibleDetails, AChimneyThatStandsOutStays) {
  const TrainingScene scene = chimney_scene(1.0);
  House shown = scene.house;
  const House faint = keep_visible_details(scene, &shown);
  EXPECT_EQ(shown.chimneys.size(), 1u);
  EXPECT_TRUE(faint.chimneys.empty());
}

TEST(VisibleDetails, ALowChimneyIsFaint) {
  const TrainingScene scene = chimney_scene(0.2);
  House shown = scene.house;
  const House faint = keep_visible_details(scene, &shown);
  EXPECT_TRUE(shown.chimneys.empty());
  EXPECT_EQ(faint.chimneys.size(), 1u);
}

TEST(VisibleDetails, WhatATreeCoversOrNoCellMeasuresIsFaint) {
  for (const float covered : {15.0f, std::numeric_limits<float>::quiet_NaN()}) {
    TrainingScene scene = chimney_scene(1.0);
    for (float& height : scene.dsm.values) height = covered;
    House shown = scene.house;
    EXPECT_EQ(keep_visible_details(scene, &shown).chimneys.size(), 1u);
    EXPECT_TRUE(shown.chimneys.empty());
  }
}

}  // namespace
}  // namespace gable
