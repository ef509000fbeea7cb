#include <gable/engine/reconstruct/choice/roof_simplification.h>
#include <gtest/gtest.h>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kNoise = 0.15;

// Edges in place, and misses that saturate: a loss that does not would rather lower a gable's end
// than show ground beside it.
PenaltyOptions penalty() { return {0.25, LossKind::kGemanMcClure, 0.4, kNoise}; }

HeightImage noisy(const House& house) { return image_of(house, {.noise = kNoise, .seed = 4}); }

TEST(RoofSimplification, AHipWithoutRunsBecomesAGable) {
  const HeightImage image = noisy(box_house(12.0, 8.0, gable_roof(5.0, 2.5, Axis::kX), 0.3));
  for (const double ratio : {0.0, 0.02}) {
    House house = box_house(12.0, 8.0, hip_roof(5.0, 2.5, ratio, ratio, Axis::kX), 0.3);
    EXPECT_EQ(simplify_roofs(image, penalty(), &house), 1) << ratio;
    EXPECT_EQ(house.roofs[0].kind, RuleKind::kRoofGable);
    EXPECT_EQ(house.roofs[0].ridge, Axis::kX);
    EXPECT_EQ(house.roofs[0][param::roof::kEaves], 5.0);
    EXPECT_EQ(house.roofs[0][param::roof::kRise], 2.5);
  }
}

TEST(RoofSimplification, ARidgeThatHardlyRisesBecomesFlat) {
  const HeightImage image = noisy(box_house(12.0, 8.0, flat_roof(5.0), 0.3));
  for (const Rule& roof :
       {gable_roof(5.0, 0.0, Axis::kX), gable_roof(4.96, 0.1, Axis::kY),
        hip_roof(5.0, 0.0, 0.2, 0.2, Axis::kX), hip_roof(4.96, 0.1, 0.0, 0.0, Axis::kY)}) {
    House house = box_house(12.0, 8.0, roof, 0.3);
    EXPECT_GE(simplify_roofs(image, penalty(), &house), 1);
    EXPECT_EQ(house.roofs[0].kind, RuleKind::kRoofFlat);
    EXPECT_NEAR(house.roofs[0][param::roof::kEaves], 5.0, 0.01);
  }
}

TEST(RoofSimplification, TrueHipsGablesAndFlatRoofsStay) {
  for (const Rule& roof :
       {hip_roof(5.0, 2.5, 0.33, 0.33, Axis::kX), hip_roof(5.0, 2.5, 0.3, 0.0, Axis::kX),
        gable_roof(5.0, 2.5, Axis::kY), flat_roof(5.0)}) {
    const House truth = box_house(12.0, 8.0, roof, 0.3);
    House house = truth;
    EXPECT_EQ(simplify_roofs(noisy(truth), penalty(), &house), 0) << rule_name(roof.kind);
    EXPECT_EQ(house.roofs[0].kind, roof.kind);
    EXPECT_EQ(house.roofs[0].values, truth.roofs[0].values);
  }
}

TEST(RoofSimplification, DecidesForEachRoofByItself) {
  House truth = make_house(Foundation::kII);
  truth.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 8.0, -3.0, 3.0)};
  truth.roofs = {hip_roof(5.0, 2.5, 0.3, 0.3, Axis::kX), gable_roof(4.0, 2.0, Axis::kX)};
  House house = truth;
  house.roofs[1] = hip_roof(4.0, 2.0, 0.0, 0.0, Axis::kX);
  EXPECT_EQ(simplify_roofs(noisy(truth), penalty(), &house), 1);
  EXPECT_EQ(house.roofs[0].kind, RuleKind::kRoofHip);
  EXPECT_EQ(house.roofs[1].kind, RuleKind::kRoofGable);
}

}  // namespace
}  // namespace gable
