#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/building/roof_closing.h>
#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace gable {
namespace {

// Heights over level ground at 0, pixels of half a metre, `size` a side, its centre at the origin.
HeightImage image_over(const PlanPolygon& outline,
                       const std::function<double(const Eigen::Vector2d&)>& height, int size) {
  HeightImage image;
  image.rows = image.cols = size;
  const double half = 0.5 * (size - 1) * image.gsd;
  image.first_center = {-half, half};
  image.ground.assign(image.size(), 0.0f);
  image.weight.assign(image.size(), 1.0f);
  Random random(3);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      const bool inside = ring_holds(outline.outer, p);
      image.inside.push_back(inside);
      image.height.push_back(static_cast<float>((inside ? height(p) : 0.0) + random.normal(0.03)));
    }
  }
  return image;
}

// A butterfly roof on a trapezium: nothing that the grammar knows.
const PlanPolygon kTrapezium{{{-8, -6}, {9, -6}, {6, 7}, {-8, 7}}, {}};

double butterfly(const Eigen::Vector2d& p) { return 4.0 + 0.5 * std::abs(p.x()); }

TEST(RoofClosing, PlanesOfAButterflyRoofAreClosedOverItsOutline) {
  const HeightImage image = image_over(kTrapezium, butterfly, 48);
  Building building;
  building.outline = kTrapezium;
  building.height = 6.0;
  ASSERT_EQ(close_roof(image, {}, &building), "");
  EXPECT_EQ(building.status, BuildingStatus::kPlanes);
  ASSERT_TRUE(building.roof);
  EXPECT_EQ(building.roof->planes.size(), 2u);
  EXPECT_LT(fit_of_building(image, building).mad, 0.06);
  const BuildingModel model = build_model(building);
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.parts[0].solids.size(), 3u);
}

TEST(RoofClosing, WithoutHeightsThereIsAReasonAndTheBuildingStays) {
  HeightImage image = image_over(kTrapezium, butterfly, 48);
  std::fill(image.weight.begin(), image.weight.end(), 0.0f);
  Building building;
  building.status = BuildingStatus::kExtrusion;
  building.outline = kTrapezium;
  EXPECT_EQ(close_roof(image, {}, &building), "no heights inside the outline");
  EXPECT_EQ(building.status, BuildingStatus::kExtrusion);
  EXPECT_FALSE(building.roof);
}

TEST(ReconstructBuilding, OutsideTheGrammarThePlanesWinAndTheReasonSaysWhy) {
  const HeightImage image = image_over(kTrapezium, butterfly, 48);
  BuildingOptions options;
  options.planes_from = 0.0;
  options.planes_margin = 0.05;
  const ReconstructedBuilding made = reconstruct_building("b", image, &kTrapezium, options);
  EXPECT_EQ(made.building.status, BuildingStatus::kPlanes);
  EXPECT_NE(made.building.reason.find("the planes of its roof"), std::string::npos)
      << made.building.reason;
  EXPECT_LT(made.building.quality.mad, 0.06);
}

TEST(RoofClosingOptions, BoundsAreNamed) {
  EXPECT_EQ(check(RoofClosingOptions{}), "");
  RoofClosingOptions options;
  options.outline_tolerance = -1.0;
  EXPECT_EQ(check(options), "outline_tolerance must lie in [0, 10] m");
  BuildingOptions building;
  building.planes_ratio = 2.0;
  EXPECT_EQ(check(building), "planes_ratio must lie in [0, 1]");
}

}  // namespace
}  // namespace gable
