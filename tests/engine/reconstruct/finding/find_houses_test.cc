#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

HeightRaster flat_ground() { return HeightRaster({{1000.0, 2000.0}, 0.5, 80, 100}, 20.0f); }

void raise(int row0, int col0, int rows, int cols, float height, HeightRaster* dsm) {
  for (int row = row0; row < row0 + rows; ++row) {
    for (int col = col0; col < col0 + cols; ++col) dsm->at(row, col) = 20.0f + height;
  }
}

TEST(FindHouses, PiecesThatAreHighAndLargeEnoughAreHouses) {
  HeightRaster dsm = flat_ground();
  raise(10, 10, 16, 20, 5.0f, &dsm);  // a house
  raise(10, 40, 16, 20, 1.9f, &dsm);  // too low
  raise(40, 40, 6, 6, 3.0f, &dsm);    // 9 square metres
  raise(60, 60, 8, 8, 3.0f, &dsm);    // 16 square metres: just enough
  dsm.at(15, 15) = std::numeric_limits<float>::quiet_NaN();
  const FoundHouses found = find_houses(dsm, flat_ground(), {});
  ASSERT_EQ(found.houses.size(), 2u);
  EXPECT_EQ(found.houses[0].num_cells, 16 * 20 - 1);
  EXPECT_EQ(found.houses[0].box.row0, 10);
  EXPECT_EQ(found.houses[0].box.col1, 30);
  EXPECT_EQ(found.label.at(10, 10), 1);
  EXPECT_EQ(found.label.at(15, 15), 0);
  EXPECT_EQ(found.label.at(61, 61), 2);
  EXPECT_EQ(found.label.at(41, 41), FoundHouses::kDropped);
  EXPECT_EQ(found.label.at(11, 41), 0);
  EXPECT_EQ(found.num_small, 1);
}

TEST(FindHouses, PiecesThatTouchInCornersOnlyAreTwo) {
  HeightRaster dsm = flat_ground();
  raise(10, 10, 10, 10, 5.0f, &dsm);
  raise(20, 20, 10, 10, 5.0f, &dsm);
  EXPECT_EQ(find_houses(dsm, flat_ground(), {}).houses.size(), 2u);
}

TEST(FindHouses, ATreeIsNoHouse) {
  HeightRaster dsm = flat_ground();
  Random random(5);
  for (int row = 20; row < 50; ++row) {
    for (int col = 20; col < 50; ++col) {
      if (std::hypot(row - 35, col - 35) < 14.0) {
        dsm.at(row, col) = static_cast<float>(random.uniform(25.0, 28.0));
      }
    }
  }
  const FoundHouses found = find_houses(dsm, flat_ground(), {});
  EXPECT_TRUE(found.houses.empty());
  EXPECT_EQ(found.crown.at(35, 35), 1);
}

TEST(FindHouses, RoughPlantOnARoofBelongsToItAndATreeBesideItDoesNot) {
  HeightRaster dsm = flat_ground();
  raise(10, 10, 40, 40, 6.0f, &dsm);
  Random random(5);
  for (int row = 0; row < dsm.grid.rows; ++row) {
    for (int col = 0; col < dsm.grid.cols; ++col) {
      const bool plant = std::hypot(row - 30, col - 30) < 6.0;
      const bool tree = std::hypot(row - 30, col - 58) < 8.0;
      if (plant || tree) dsm.at(row, col) = static_cast<float>(random.uniform(26.0, 29.0));
    }
  }
  const FoundHouses found = find_houses(dsm, flat_ground(), {});
  ASSERT_EQ(found.houses.size(), 1u);
  EXPECT_EQ(found.label.at(30, 30), 1);
  EXPECT_EQ(found.crown.at(30, 30), 0);
  EXPECT_EQ(found.crown.at(30, 60), 1);
  EXPECT_EQ(found.label.at(30, 60), 0);
  FindHousesOptions options;
  options.roof_rim = 1.0;
  EXPECT_EQ(find_houses(dsm, flat_ground(), options).crown.at(30, 30), 1);
}

TEST(FindHouses, WhatStandsAtAFacadeBelongsToTheHouseAndATreeBehindItDoesNot) {
  HeightRaster dsm = flat_ground();
  raise(10, 10, 30, 60, 8.0f, &dsm);
  Random random(5);
  // Creepers of 1.5 m along the facade, and a tree that touches them.
  for (int row = 40; row < 60; ++row) {
    for (int col = 10; col < 70; ++col) {
      const bool tree = row >= 43 && std::hypot(row - 50, col - 40) < 8.0;
      if (row < 43 || tree) dsm.at(row, col) = static_cast<float>(random.uniform(23.0, 26.0));
    }
  }
  FindHousesOptions options;
  options.facade = 1.5;
  const FoundHouses found = find_houses(dsm, flat_ground(), options);
  ASSERT_EQ(found.houses.size(), 1u);
  EXPECT_EQ(found.label.at(41, 30), 1);
  EXPECT_EQ(found.crown.at(50, 40), 1);
  EXPECT_EQ(found.label.at(50, 40), 0);
  options.facade = 0.0;
  EXPECT_EQ(find_houses(dsm, flat_ground(), options).crown.at(41, 30), 1);
}

TEST(FindHouses, OnlyHousesNearFootprintsAreKept) {
  HeightRaster dsm = flat_ground();
  raise(10, 10, 16, 20, 5.0f, &dsm);
  raise(50, 60, 16, 20, 5.0f, &dsm);
  FoundHouses found = find_houses(dsm, flat_ground(), {});
  ASSERT_EQ(found.houses.size(), 2u);
  // Half as large as the second house and around its centre: enlarged by two it just holds it.
  const Eigen::Vector2d center = dsm.grid.north_west + Eigen::Vector2d(35.0, -29.0);
  PlanPolygon polygon;
  for (const auto& [x, y] : {std::pair(-2.5, -2.0), {2.5, -2.0}, {2.5, 2.0}, {-2.5, 2.0}}) {
    polygon.outer.push_back(center + Eigen::Vector2d(x, y));
  }
  EXPECT_EQ(keep_near_footprints({polygon}, &found), 1);
  ASSERT_EQ(found.houses.size(), 1u);
  EXPECT_EQ(found.houses[0].box.row0, 50);
  EXPECT_EQ(found.label.at(50, 60), 1);
  EXPECT_EQ(found.label.at(10, 10), FoundHouses::kDropped);
  polygon.outer[0] = polygon.outer[1];
  polygon.outer[3] = polygon.outer[2];
  EXPECT_EQ(keep_near_footprints({polygon}, &found), 1);
}

}  // namespace
}  // namespace gable
