#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

// Slopes of the planes, in their order.
std::vector<double> slopes_of(const HouseScale& scale) {
  std::vector<double> slopes;
  for (const HousePlane& p : scale.planes) slopes.push_back(std::hypot(p.plane.a, p.plane.b));
  return slopes;
}

TEST(HouseScales, AnExactGableHasTwoPlanesWithItsSlopesAndHeights) {
  const House house = box_house(14.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  const HouseScales scales = house_scales(image_of(house), nullptr);
  const HouseScale& roofs = scales.roofs();
  ASSERT_EQ(roofs.planes.size(), 2u);
  for (const HousePlane& p : roofs.planes) {
    EXPECT_NEAR(std::hypot(p.plane.a, p.plane.b), 3.0 / 4.0, 0.01);
    EXPECT_LT(p.rms, 0.05);
    EXPECT_NEAR(p.plane.at({0.0, 0.0}), 8.0, 0.03);  // the ridge
  }
  EXPECT_NEAR(roofs.planes[0].plane.a, -roofs.planes[1].plane.a, 0.01);
  EXPECT_NEAR(roofs.planes[0].plane.b, -roofs.planes[1].plane.b, 0.01);
  EXPECT_GT(roofs.coverage, 0.9);
}

TEST(HouseScales, AnExactHipHasFourPlanes) {
  const House house = box_house(16.0, 10.0, hip_roof(5.0, 3.0, 0.3, 0.3, Axis::kX), 0.7);
  const HouseScales scales = house_scales(image_of(house), nullptr);
  ASSERT_EQ(scales.roofs().planes.size(), 4u);
  const std::vector<double> slopes = slopes_of(scales.roofs());
  EXPECT_NEAR(slopes[0], 0.6, 0.02);
  EXPECT_NEAR(slopes[1], 0.6, 0.02);
  EXPECT_NEAR(slopes[2], 3.0 / 4.8, 0.03);
  EXPECT_NEAR(slopes[3], 3.0 / 4.8, 0.03);
}

TEST(HouseScales, PixelsOfAPlaneLieOnTheTrueSurface) {
  ViewOptions view;
  view.noise = 0.08;
  const House house = box_house(16.0, 10.0, hip_roof(5.0, 3.0, 0.25, 0.25, Axis::kX), 0.2);
  const HeightImage image = image_of(house, view);
  const HeightField field(house);
  const HouseScales scales = house_scales(image, nullptr);
  size_t near = 0, all = 0;
  for (const HousePlane& p : scales.roofs().planes) {
    EXPECT_TRUE(std::is_sorted(p.pixels.begin(), p.pixels.end()));
    for (const int pixel : p.pixels) {
      const Eigen::Vector2d at = image.center_of(pixel / image.cols, pixel % image.cols);
      near += std::abs(p.plane.at(at) - field.at_local(at, 0.0, 0.0)) < 0.15;
      ++all;
    }
  }
  EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(all));
  EXPECT_NEAR(scales.noise, 0.08, 0.02);
}

TEST(HouseScales, ScalesGrowCoarser) {
  ViewOptions view;
  view.noise = 0.05;
  House house = box_house(16.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), 0.2);
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.values = {1.0, -2.0, 3.0, 3.0, 7.4, 0.4};
  dormer.component = 0;
  house.dormers = {dormer};
  const HouseScales scales = house_scales(image_of(house, view), nullptr);
  EXPECT_GE(scales.details().planes.size(), 3u);
  EXPECT_LE(scales.details().configuration, scales.roofs().configuration);
  EXPECT_LE(scales.roofs().configuration, scales.blocks().configuration);
  EXPECT_GE(scales.roofs().planes.size(), 2u);
}

TEST(HouseScales, LargeHousesAreThinned) {
  HouseScalesOptions options;
  options.most_points = 100;
  const HeightImage image = image_of(box_house(16.0, 10.0, gable_roof(5.0, 3.0, Axis::kX), 0.1));
  const HouseScales scales = house_scales(image, nullptr, options);
  EXPECT_EQ(scales.stride, 3);
  EXPECT_LE(scales.num_points, 120);
  EXPECT_EQ(scales.roofs().planes.size(), 2u);
}

TEST(HouseScales, NothingSeenGivesNoPlanes) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  image.inside.assign(image.size(), 0);
  const HouseScales scales = house_scales(image, nullptr);
  EXPECT_TRUE(scales.details().planes.empty());
  EXPECT_TRUE(scales.roofs().planes.empty());
  EXPECT_TRUE(scales.blocks().planes.empty());
}

TEST(HouseScales, OptionsOutOfRangeAreNamed) {
  HouseScalesOptions options;
  EXPECT_EQ(check(options), "");
  options.most_noise = 0.01;
  EXPECT_EQ(check(options), "most_noise is below least_noise");
  options = {};
  options.neighbours = 3;
  EXPECT_EQ(check(options), "neighbours must lie in [4, 50]");
}

}  // namespace
}  // namespace gable
