#include <gable/engine/reconstruct/first_values/plane_blocks.h>
#include <gtest/gtest.h>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kAzimuth = 0.3;

std::vector<PlaneBlock> blocks_of(const House& house, double noise = 0.0) {
  ViewOptions view;
  view.noise = noise;
  view.size = 80;
  const HeightImage image = image_of(house, view);
  const HouseScales scales = house_scales(image, nullptr);
  return plane_blocks(image, scales.roofs(), image.gsd * scales.stride, house.azimuth[0]);
}

void expect_rectangle(const RoofedRectangle& r, double x0, double x1, double y0, double y1,
                      double tolerance) {
  EXPECT_NEAR(r.x0, x0, tolerance);
  EXPECT_NEAR(r.x1, x1, tolerance);
  EXPECT_NEAR(r.y0, y0, tolerance);
  EXPECT_NEAR(r.y1, y1, tolerance);
}

TEST(PlaneBlocks, AGableIsReadOffItsTwoPlanes) {
  for (const double noise : {0.0, 0.1}) {
    const auto blocks =
        blocks_of(box_house(14.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), kAzimuth), noise);
    ASSERT_EQ(blocks.size(), 1u);
    expect_rectangle(blocks[0].roofed, -7.0, 7.0, -4.0, 4.0, 0.5);
    const Rule& roof = blocks[0].roofed.roof;
    EXPECT_EQ(roof.ridge, Axis::kX);
    EXPECT_NEAR(roof[param::roof::kEaves] + roof[param::roof::kRise], 8.0, 0.1);  // the ridge
    EXPECT_NEAR(roof[param::roof::kEaves], 5.0, 0.4);
    EXPECT_EQ(blocks[0].planes.size(), 2u);
    EXPECT_EQ(blocks[0].roof_origin.substr(0, 16), "crease of planes");
  }
}

TEST(PlaneBlocks, HipsEndWhereThreePlanesMeet) {
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const bool along_x = axis == Axis::kX;
    const auto blocks = blocks_of(box_house(along_x ? 18.0 : 10.0, along_x ? 10.0 : 18.0,
                                            hip_roof(5.0, 3.0, 0.2, 0.35, axis), kAzimuth),
                                  0.05);
    ASSERT_EQ(blocks.size(), 1u);
    const Rule& roof = blocks[0].roofed.roof;
    EXPECT_EQ(roof.ridge, axis);
    EXPECT_NEAR(roof[param::roof::kHipStart], 0.2, 0.04);
    EXPECT_NEAR(roof[param::roof::kHipEnd], 0.35, 0.04);
    EXPECT_NEAR(roof[param::roof::kEaves], 5.0, 0.4);
    EXPECT_NEAR(roof[param::roof::kRise], 3.0, 0.4);
    EXPECT_EQ(blocks[0].planes.size(), 4u);
  }
}

TEST(PlaneBlocks, BlocksUnderOneEnvelopeAreTakenApart) {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = kAzimuth;
  house.footprints = {rectangle_rule(-9.0, 9.0, -4.0, 4.0), rectangle_rule(-3.0, 3.0, 3.0, 12.0)};
  house.roofs = {gable_roof(5.0, 3.0, Axis::kX), gable_roof(4.0, 2.0, Axis::kY)};
  const auto blocks = blocks_of(house, 0.05);
  ASSERT_EQ(blocks.size(), 2u);
  expect_rectangle(blocks[0].roofed, -9.0, 9.0, -4.0, 4.0, 0.6);
  EXPECT_EQ(blocks[0].roofed.roof.ridge, Axis::kX);
  EXPECT_EQ(blocks[1].roofed.roof.ridge, Axis::kY);
  EXPECT_NEAR(blocks[1].roofed.x0, -3.0, 0.6);
  EXPECT_NEAR(blocks[1].roofed.x1, 3.0, 0.6);
  EXPECT_NEAR(blocks[1].roofed.y1, 12.0, 0.6);
  EXPECT_NEAR(blocks[1].roofed.roof[param::roof::kEaves], 4.0, 0.4);
}

TEST(PlaneBlocks, AFlatRoofThatFillsItsRectangleBadlyIsTwo) {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = kAzimuth;
  house.footprints = {rectangle_rule(-9.0, 9.0, -9.0, -2.0), rectangle_rule(-9.0, -2.0, -9.0, 9.0)};
  house.roofs = {flat_roof(6.0), flat_roof(6.0)};
  const auto blocks = blocks_of(house);
  ASSERT_EQ(blocks.size(), 2u);
  double area = 0.0;
  for (const PlaneBlock& block : blocks) {
    const RoofedRectangle& r = block.roofed;
    EXPECT_EQ(r.roof.kind, RuleKind::kRoofFlat);
    EXPECT_NEAR(r.roof[param::roof::kEaves], 6.0, 0.01);
    area += (r.x1 - r.x0) * (r.y1 - r.y0);
  }
  EXPECT_NEAR(area, 18.0 * 7.0 + 7.0 * 11.0, 20.0);
}

TEST(PlaneBlocks, OptionsOutOfRangeAreNamed) {
  PlaneBlockOptions options;
  EXPECT_EQ(check(options), "");
  options.least_fill = 1.0;
  EXPECT_EQ(check(options), "least_fill must lie in (0, 1)");
}

}  // namespace
}  // namespace gable
