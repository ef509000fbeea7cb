#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/choice/mansard_roofs.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kNoise = 0.15;

PenaltyOptions penalty() { return {0.25, LossKind::kGemanMcClure, 0.4, kNoise}; }

HeightImage noisy(const House& house) {
  return image_of(house, {.noise = kNoise, .outliers = 0.02, .seed = 4});
}

TEST(BrokenProfile, IsFoundWhereHeightsFollowOne) {
  std::vector<Eigen::Vector2d> samples;
  for (int i = 0; i <= 40; ++i) {
    const double s = i / 40.0;
    samples.emplace_back(s, 4.0 + (s < 0.3 ? 3.0 * s / 0.3 : 3.0 + 1.4 * (s - 0.3) / 0.7));
  }
  samples.emplace_back(0.5, 30.0);  // a bird
  const auto profile = fit_broken_profile(samples, RobustLoss(LossKind::kGemanMcClure, 0.5));
  ASSERT_TRUE(profile);
  EXPECT_NEAR(profile->break_run, 0.3, 1e-12);
  EXPECT_NEAR(profile->eaves, 4.0, 0.01);
  EXPECT_NEAR(profile->lower_rise, 3.0, 0.01);
  EXPECT_NEAR(profile->upper_rise, 1.4, 0.01);
  EXPECT_GT(profile->saved, 1.0);
}

TEST(BrokenProfile, SavesNothingOnAStraightOneAndNeedsSamples) {
  const RobustLoss loss(LossKind::kSoftL1, 0.3);
  std::vector<Eigen::Vector2d> samples;
  EXPECT_FALSE(fit_broken_profile(samples, loss));
  for (int i = 0; i <= 40; ++i) samples.emplace_back(i / 40.0, 4.0 + 3.0 * i / 40.0);
  const auto profile = fit_broken_profile(samples, loss);
  ASSERT_TRUE(profile);
  EXPECT_NEAR(profile->saved, 0.0, 1e-6);
}

TEST(MansardRoofs, AMansardIsRecoveredFromAGableWithNoise) {
  for (const Axis ridge : {Axis::kX, Axis::kY}) {
    const House truth = box_house(13.0, 10.0, mansard_roof(3.0, 4.5, 0.7, 0.3, ridge), 0.4);
    House house = truth;
    house.footprints[0].values = {0.3, -0.4, 12.5, 10.4};
    house.roofs[0] = gable_roof(4.5, 3.5, ridge);
    EXPECT_EQ(make_mansards(noisy(truth), penalty(), &house), 1);
    ASSERT_EQ(house.roofs[0].kind, RuleKind::kRoofMansard);
    EXPECT_EQ(house.roofs[0].ridge, ridge);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(house.roofs[0][k], truth.roofs[0][k], 0.25) << k;
    for (int k = 2; k < 4; ++k) EXPECT_NEAR(house.roofs[0][k], truth.roofs[0][k], 0.03) << k;
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(house.footprints[0][k], truth.footprints[0][k], 0.2) << k;
    }
  }
}

TEST(MansardRoofs, GablesHipsAndFlatRoofsStay) {
  for (const Rule& roof : {hip_roof(5.0, 2.5, 0.33, 0.33, Axis::kX), gable_roof(5.0, 2.5, Axis::kY),
                           gable_roof(3.0, 6.0, Axis::kX), flat_roof(5.0)}) {
    const House truth = box_house(12.0, 8.0, roof, 0.3);
    House house = truth;
    EXPECT_EQ(make_mansards(noisy(truth), penalty(), &house), 0) << rule_name(roof.kind);
    EXPECT_EQ(house.roofs[0].values, truth.roofs[0].values);
    EXPECT_EQ(house.footprints[0].values, truth.footprints[0].values);
  }
}

TEST(MansardRoofs, ASmearedWallIsNoBrokenRoof) {
  const House gable = box_house(13.0, 10.0, gable_roof(4.0, 2.5, Axis::kX), 0.35);
  HeightImage image = image_of_means(gable, 2.4, {.noise = 0.05});
  House house = gable;
  make_mansards(image, penalty(), &house);
  EXPECT_EQ(house.roofs[0].kind, RuleKind::kRoofGable);
  image.spread = 0.0;
  make_mansards(image, penalty(), &house);
  EXPECT_EQ(house.roofs[0].kind, RuleKind::kRoofMansard) << "the smear must be told";
}

TEST(MansardRoofs, ReconstructionFindsThem) {
  const Scene scene = make_scene(
      box_house(13.0, 10.0, mansard_roof(3.0, 4.5, 0.7, 0.3, Axis::kX), 0.4), {.trees = 0});
  const HouseChoice choice = choose_house(image_of(scene), {});
  ASSERT_TRUE(choice.found);
  EXPECT_EQ(choice.best.house.foundation, Foundation::kI);
  EXPECT_EQ(choice.best.house.roofs[0].kind, RuleKind::kRoofMansard);
  EXPECT_LT(choice.summary.mad, 0.25);
}

}  // namespace
}  // namespace gable
