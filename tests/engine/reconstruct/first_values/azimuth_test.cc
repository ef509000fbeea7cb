#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;

double quarter_turn_distance(double a, double b) {
  return std::abs(std::remainder(a - b, 0.5 * M_PI));
}

TEST(Azimuth, IsWithinTwoDegreesOfBoxesAtAnyAngleUnderAnyRoof) {
  const Rule roofs[] = {flat_roof(5.0), gable_roof(5.0, 2.5, Axis::kX),
                        hip_roof(5.0, 2.5, 0.3, 0.3, Axis::kX)};
  for (const Rule& roof : roofs) {
    for (int degrees = -40; degrees <= 200; degrees += 7) {
      const double azimuth = degrees * kDegree;
      // A wall turned by 2 degrees is one step of a 0.5 m staircase: without slopes it takes 0.25
      // m.
      const bool flat = roof.kind == RuleKind::kRoofFlat;
      const ViewOptions seen{.gsd = flat ? 0.25 : 0.5, .size = flat ? 128 : 64};
      const auto candidates =
          azimuth_candidates(image_of(box_house(12.0, 8.0, roof, azimuth), seen), 7.0 * kDegree);
      ASSERT_EQ(candidates.size(), 1u) << rule_name(roof.kind) << " at " << degrees;
      EXPECT_LT(quarter_turn_distance(candidates[0].azimuth, azimuth), 2.0 * kDegree)
          << rule_name(roof.kind) << " at " << degrees;
      EXPECT_GE(candidates[0].azimuth, 0.0);
      EXPECT_LT(candidates[0].azimuth, 0.5 * M_PI);
      EXPECT_GT(candidates[0].strength, 0.5);
      EXPECT_LE(candidates[0].strength, 1.0);
    }
  }
}

TEST(Azimuth, OfOutlineAndRoofAreBothGivenWhereTheyDisagree) {
  // The outline of a box, and within it a slope that rises in another direction.
  const double outline = 10.0 * kDegree, roof = 40.0 * kDegree;
  HeightImage image = image_of(box_house(14.0, 9.0, flat_roof(5.0), outline));
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      if (image.inside[image.index(row, col)]) {
        image.height[image.index(row, col)] =
            static_cast<float>(10.0 + 0.6 * (std::cos(roof) * p.x() + std::sin(roof) * p.y()));
      }
    }
  }
  const auto candidates = azimuth_candidates(image, 7.0 * kDegree);
  ASSERT_EQ(candidates.size(), 3u);
  EXPECT_LT(quarter_turn_distance(candidates[1].azimuth, outline), 2.0 * kDegree);
  EXPECT_LT(quarter_turn_distance(candidates[2].azimuth, roof), 2.0 * kDegree);
  // The wider the separation, the less is told apart.
  EXPECT_EQ(azimuth_candidates(image, 40.0 * kDegree).size(), 1u);
}

}  // namespace
}  // namespace gable
