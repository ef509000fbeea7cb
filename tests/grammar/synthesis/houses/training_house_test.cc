#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/training_house.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr Foundation kAll[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                               Foundation::kU};

TEST(TrainingHouse, IsDistinctAndWithinTheBoundsOfItsRules) {
  Random random(1);
  for (Foundation foundation : kAll) {
    for (int i = 0; i < 300; ++i) {
      const House house = random_training_house(foundation, &random, PriorOptions());
      ASSERT_EQ(house.foundation, foundation);
      ASSERT_TRUE(is_well_formed(house));
      EXPECT_TRUE(is_distinct(house));
      for (const Rule* rule : house.derivation()) {
        const auto specs = parameter_specs(rule->kind);
        for (int p = 0; p < rule->size(); ++p) {
          EXPECT_GE((*rule)[p], specs[p].lower - 1e-9) << rule_name(rule->kind) << specs[p].name;
          EXPECT_LE((*rule)[p], specs[p].upper + 1e-9) << rule_name(rule->kind) << specs[p].name;
        }
      }
    }
  }
}

TEST(TrainingHouse, ReachesFromBungalowsToHighAndFromShallowToSteep) {
  Random random(2);
  double least_pitch = 90.0, most_pitch = 0.0, least_eaves = 99.0, most_eaves = 0.0, longest = 0.0;
  int flat = 0, low_garages = 0, box_dormers = 0;
  constexpr int kHouses = 1500;
  for (int i = 0; i < kHouses; ++i) {
    const House house = random_training_house(Foundation::kI, &random, PriorOptions());
    const Block<double> block = expand_blocks(house)[0];
    using namespace block_value;
    const Rectangle r = rectangle_of(block);
    longest = std::max({longest, r.size_x(), r.size_y()});
    least_eaves = std::min(least_eaves, block[kEaves]);
    most_eaves = std::max(most_eaves, block[kEaves]);
    for (const Rule& garage : house.garages) {
      low_garages += garage.kind == RuleKind::kGarageI && garage[param::garage::kHeightI] < 2.2;
    }
    for (const Rule& dormer : house.dormers) box_dormers += dormer[param::dormer::kRise] == 0.0;
    if (block.flat) {
      ++flat;
      continue;
    }
    const double span = block.ridge == Axis::kX ? r.size_y() : r.size_x();
    const double pitch = std::atan(block[kRise] / (0.5 * span)) * 180.0 / M_PI;
    least_pitch = std::min(least_pitch, pitch);
    most_pitch = std::max(most_pitch, pitch);
  }
  EXPECT_LT(least_pitch, 17.0);
  EXPECT_GE(least_pitch, 15.0 - 1e-6);
  EXPECT_GT(most_pitch, 57.0);
  EXPECT_LE(most_pitch, 60.0 + 1e-6);
  EXPECT_LT(least_eaves, 2.4);
  EXPECT_GT(most_eaves, 8.5);
  EXPECT_GT(longest, 23.0);
  EXPECT_GT(flat, kHouses * 0.05);
  EXPECT_LT(flat, kHouses * 0.12);
  EXPECT_GT(low_garages, 0);
  EXPECT_GT(box_dormers, 0);
}

TEST(TrainingHouse, HasNoDetailsWhereNoneAreWanted) {
  PriorOptions options;
  options.dormer_share = options.chimney_share = options.garage_share = 0.0;
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const House house = random_training_house(kAll[i % 5], &random, options);
    EXPECT_TRUE(house.dormers.empty());
    EXPECT_TRUE(house.chimneys.empty());
    EXPECT_TRUE(house.garages.empty());
  }
}

}  // namespace
}  // namespace gable
