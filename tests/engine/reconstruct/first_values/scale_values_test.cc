#include <gable/engine/reconstruct/first_values/scale_values.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

std::vector<FirstValue> values_of(const HeightImage& image) {
  return scale_values(image, house_scales(image, nullptr));
}

// Mean absolute difference of a house to an image's inside pixels that it covers, metres, and the
// share of the inside pixels that it covers: from the height field alone, whatever was fitted how.
struct Distance {
  double mad = 0.0, covered = 0.0;
};

Distance distance(const House& house, const HeightImage& image) {
  const HeightField field(house);
  double sum = 0.0;
  int inside = 0, covered = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!image.inside[i]) continue;
      ++inside;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      if (field.block_at_house(p) < 0) continue;
      ++covered;
      sum += std::abs(field.at_house(p, 0.0, 0.0) - image.height[i]);
    }
  }
  return {sum / std::max(1, covered), static_cast<double>(covered) / std::max(1, inside)};
}

const FirstValue* of_type(const std::vector<FirstValue>& values, Foundation type) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const FirstValue& v) { return v.house.foundation == type; });
  return found == values.end() ? nullptr : &*found;
}

TEST(ScaleValues, AHippedHouseIsNearlyThereBeforeAnyRefinement) {
  const House house = box_house(16.0, 10.0, hip_roof(5.0, 3.0, 0.25, 0.3, Axis::kX), 0.4);
  const HeightImage image = image_of(house, {.noise = 0.08});
  const auto values = values_of(image);
  const FirstValue* first = of_type(values, Foundation::kI);
  ASSERT_NE(first, nullptr);
  EXPECT_NEAR(std::remainder(first->house.azimuth[0] - 0.4, 0.5 * M_PI), 0.0, 0.02);
  const Distance d = distance(first->house, image);
  EXPECT_LT(d.mad, 0.2);
  EXPECT_GT(d.covered, 0.9);
}

TEST(ScaleValues, AnLHasItsSharedCorner) {
  for (const Side& corner : {Side(-1, -1), Side(1, -1), Side(1, 1), Side(-1, 1)}) {
    // Wings of an L about the origin whose outer corner lies at 9 * corner.
    const auto low = [](double s, double reach) { return s < 0.0 ? -9.0 : 9.0 - reach; };
    RoofedRectangle x{-9.0, 9.0, low(corner.y(), 7.0), low(corner.y(), 7.0) + 7.0,
                      gable_roof(5.0, 3.0, Axis::kX)};
    RoofedRectangle y{low(corner.x(), 6.0), low(corner.x(), 6.0) + 6.0, -9.0, 9.0,
                      gable_roof(5.0, 2.6, Axis::kY)};
    const House house = l_house(x, y, corner, 0.2);
    const HeightImage image = image_of(house, {.size = 80, .noise = 0.05});
    const auto values = values_of(image);
    const FirstValue* first = of_type(values, Foundation::kL);
    ASSERT_NE(first, nullptr) << corner.transpose();
    EXPECT_TRUE(is_well_formed(first->house));
    const Distance d = distance(first->house, image);
    EXPECT_LT(d.mad, 0.3);
    EXPECT_GT(d.covered, 0.9);
  }
}

TEST(ScaleValues, AUHasItsBaseAndItsWings) {
  for (const Side& open : {Side(0, 1), Side(1, 0), Side(0, -1), Side(-1, 0)}) {
    const RoofedRectangle base{-12.0, 12.0, -7.0, 0.0, gable_roof(5.0, 3.0, Axis::kX)};
    const RoofedRectangle a{-12.0, -5.0, -7.0, 10.0, gable_roof(5.0, 3.0, Axis::kY)};
    const RoofedRectangle b{5.5, 12.0, -7.0, 8.0, gable_roof(5.0, 2.8, Axis::kY)};
    House house = u_house(base, a, b, Side(0, 1), 0.1);
    house.azimuth[0] += std::atan2(open.y(), open.x()) - 0.5 * M_PI;
    const HeightImage image = image_of(house, {.size = 96, .noise = 0.05});
    const auto values = values_of(image);
    const FirstValue* first = of_type(values, Foundation::kU);
    ASSERT_NE(first, nullptr) << open.transpose();
    const Distance d = distance(first->house, image);
    EXPECT_LT(d.mad, 0.4);
    EXPECT_GT(d.covered, 0.9);
  }
}

TEST(ScaleValues, EveryRuleHasItsOriginAndHousesTheImagesOrigin) {
  House house = make_house(Foundation::kII);
  house.origin = {1000.0, 2000.0, 30.0};
  house.footprints = {rectangle_rule(-9.0, 9.0, -4.0, 4.0), rectangle_rule(-3.0, 3.0, 3.0, 12.0)};
  house.roofs = {gable_roof(5.0, 3.0, Axis::kX), gable_roof(4.0, 2.0, Axis::kY)};
  const auto values = values_of(image_of(house, {.noise = 0.05}));
  ASSERT_NE(of_type(values, Foundation::kII), nullptr);
  ASSERT_NE(of_type(values, Foundation::kI), nullptr);
  EXPECT_LE(values.size(), 4u);
  for (const FirstValue& value : values) {
    EXPECT_EQ(value.source, ValueSource::kScales);
    EXPECT_EQ(value.house.origin, house.origin);
    EXPECT_TRUE(is_well_formed(value.house));
    EXPECT_EQ(value.origins.size(), value.house.derivation().size());
    EXPECT_EQ(value.origins[0], "4 planes' normals");
  }
}

TEST(ScaleValues, LevelRoofsTakeTheOutlinesAzimuth) {
  const House house = box_house(14.0, 8.0, flat_roof(6.0), 0.5);
  const auto values = values_of(image_of(house, {.noise = 0.05}));
  ASSERT_EQ(values.size(), 1u);
  EXPECT_NEAR(std::remainder(values[0].house.azimuth[0] - 0.5, 0.5 * M_PI), 0.0, 0.05);
  EXPECT_EQ(values[0].house.roofs[0].kind, RuleKind::kRoofFlat);
  EXPECT_NEAR(values[0].house.roofs[0][param::roof::kEaves], 6.0, 0.05);
}

TEST(ScaleValues, WithoutPlanesThereAreNone) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  image.inside.assign(image.size(), 0);
  EXPECT_TRUE(values_of(image).empty());
}

TEST(ScaleValues, OptionsOutOfRangeAreNamed) {
  ScaleValuesOptions options;
  EXPECT_EQ(check(options), "");
  options.most_houses = 0;
  EXPECT_EQ(check(options), "most_houses must lie in [1, 10]");
}

}  // namespace
}  // namespace gable
