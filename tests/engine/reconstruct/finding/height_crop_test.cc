#include <gable/engine/reconstruct/finding/height_crop.h>
#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gtest/gtest.h>

#include <limits>

namespace gable {
namespace {

constexpr float kGround = 30.0f;

/// Two houses of 8 x 8 m, 2 m apart, 6 and 4 m high.
struct TwoHouses {
  TwoHouses() {
    for (int row = 20; row < 36; ++row) {
      for (int col = 20; col < 36; ++col) dsm.at(row, col) = kGround + 6.0f;
      for (int col = 40; col < 56; ++col) dsm.at(row, col) = kGround + 4.0f;
    }
  }

  HeightRaster dsm = HeightRaster({{5000.0, 7000.0}, 0.5, 60, 80}, kGround);
  HeightRaster dtm = dsm;
};

TEST(HeightCrop, OfAFoundHouseKeepsWhatIsMeasuredAndLeavesOutTheNeighbour) {
  TwoHouses scene;
  scene.dtm = HeightRaster(scene.dsm.grid, kGround);
  scene.dsm.at(25, 25) = std::numeric_limits<float>::quiet_NaN();
  const FoundHouses found = find_houses(scene.dsm, scene.dtm, {});
  ASSERT_EQ(found.houses.size(), 2u);
  const HeightImage image = crop_found_house(scene.dsm, scene.dtm, found, 0, {});
  ASSERT_EQ(image.rows, 16 + 2 * 7);
  ASSERT_EQ(image.cols, 16 + 2 * 7);
  EXPECT_EQ(image.origin, Eigen::Vector3d(5014.0, 6986.0, kGround));
  // Pixel (7, 7) is cell (20, 20).
  const Eigen::Vector2d world = image.center_of(7, 7) + image.origin.head<2>();
  EXPECT_EQ(world, scene.dsm.grid.center_of(20, 20));
  EXPECT_EQ(image.height[image.index(7, 7)], 6.0f);
  EXPECT_EQ(image.inside[image.index(7, 7)], 1);
  EXPECT_EQ(image.weight[image.index(12, 12)], 0.0f);  // no height
  EXPECT_EQ(image.weight[image.index(7, 25)], 1.0f);   // terrain between the houses
  EXPECT_EQ(image.weight[image.index(7, 26)], 0.05f);  // beside the neighbour
  EXPECT_EQ(image.weight[image.index(7, 27)], 0.05f);  // the neighbour, set aside as terrain
  EXPECT_EQ(image.height[image.index(7, 27)], 0.0f);
  EXPECT_EQ(image.inside[image.index(7, 27)], 0);
}

TEST(HeightCrop, OtherPiecesOfARowAreGroundOfSomeWeightUpToTheCut) {
  TwoHouses scene;
  scene.dtm = HeightRaster(scene.dsm.grid, kGround);
  FoundHouses found = find_houses(scene.dsm, scene.dtm, {});
  ASSERT_EQ(found.houses.size(), 2u);
  for (FoundHouse& house : found.houses) house.row = 1;
  HeightCropOptions options;
  const HeightImage row = crop_found_house(scene.dsm, scene.dtm, found, 0, options);
  const size_t other = row.index(7, 27), beside = row.index(7, 26);
  EXPECT_EQ(row.weight[other], static_cast<float>(options.row));
  EXPECT_EQ(row.height[other], 0.0f);
  EXPECT_EQ(row.inside[other], 0);
  EXPECT_EQ(row.weight[beside], 1.0f);
  // Of another row it is a neighbour like any.
  found.houses[1].row = 2;
  EXPECT_EQ(crop_found_house(scene.dsm, scene.dtm, found, 0, options).weight[other], 0.05f);
}

TEST(HeightCrop, OverAnOutlineTheBuildingEndsThere) {
  TwoHouses scene;
  scene.dtm = HeightRaster(scene.dsm.grid, kGround);
  // The outline covers the western half of the first house and leaves a hole.
  PlanPolygon polygon = {{{5010, 6982}, {5014, 6982}, {5014, 6990}, {5010, 6990}},
                         {{{5011, 6985}, {5012, 6985}, {5012, 6986}, {5011, 6986}}}};
  Raster<unsigned char> outlined(scene.dsm.grid, 0);
  for (int row = 20; row < 36; ++row) {
    for (int col = 20; col < 28; ++col) outlined.at(row, col) = 1;
    for (int col = 30; col < 36; ++col) outlined.at(row, col) = 1;  // another building's
  }
  const HeightImage image = crop_footprint(scene.dsm, scene.dtm, outlined, polygon, {});
  int inside = 0;
  for (const unsigned char own : image.inside) inside += own;
  EXPECT_EQ(inside, 16 * 8 - 4);
  const auto at = [&](int row, int col) { return image.index(row - 13, col - 13); };
  ASSERT_EQ((image.center_of(0, 0) + image.origin.head<2>()).eval(),
            scene.dsm.grid.center_of(13, 13));
  EXPECT_EQ(image.height[at(20, 20)], 6.0f);
  EXPECT_EQ(image.height[at(20, 28)], 0.0f);  // beyond the outline, of no building
  EXPECT_EQ(image.weight[at(20, 28)], static_cast<float>(HeightCropOptions().outside));
  EXPECT_EQ(image.height[at(20, 31)], 0.0f);  // of the other building
  EXPECT_EQ(image.weight[at(20, 31)], 0.05f);
}

TEST(HeightCrop, LargeCropsAreThinnedByAWholeFactor) {
  const TwoHouses scene;
  HeightCropOptions options;
  options.max_cells = 600;
  const std::vector<CellRole> roles(60 * 80, CellRole::kBuilding);
  const HeightImage image =
      crop_heights(scene.dsm, scene.dsm, {0, 0, 60, 80}, roles, false, options);
  EXPECT_EQ(image.gsd, 1.5);
  EXPECT_EQ(image.rows, 20);
  EXPECT_EQ(image.cols, 27);
  EXPECT_EQ(image.height.size(), image.size());
  const Eigen::Vector2d world = image.center_of(7, 8) + image.origin.head<2>();
  EXPECT_TRUE(world.isApprox(scene.dsm.grid.center_of(21, 24), 1e-12));
  EXPECT_EQ(image.height[image.index(7, 8)] + image.origin.z(), kGround + 6.0);
}

TEST(HeightCrop, MovingTheOriginLeavesTheWorldAsItIs) {
  const TwoHouses scene;
  const std::vector<CellRole> roles(60 * 80, CellRole::kBuilding);
  const HeightImage image = crop_heights(scene.dsm, scene.dsm, {0, 0, 60, 80}, roles, false, {});
  HeightImage moved = image;
  move_origin({5001.0, 6950.0, 10.0}, &moved);
  EXPECT_EQ(moved.origin, Eigen::Vector3d(5001.0, 6950.0, 10.0));
  EXPECT_TRUE((moved.center_of(3, 4) + moved.origin.head<2>())
                  .isApprox(image.center_of(3, 4) + image.origin.head<2>(), 1e-12));
  EXPECT_EQ(moved.height[0] + 10.0, image.height[0] + image.origin.z());
  EXPECT_EQ(moved.ground[0] + 10.0, image.ground[0] + image.origin.z());
}

}  // namespace
}  // namespace gable
