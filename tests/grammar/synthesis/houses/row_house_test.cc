#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/flat_parts.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/row_house.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr Foundation kRows[] = {Foundation::kI, Foundation::kII, Foundation::kIII};

TEST(RowHouse, IsDistinctAndWithinTheBoundsOfItsRules) {
  Random random(1);
  for (Foundation foundation : kRows) {
    for (int i = 0; i < 300; ++i) {
      const House house = random_row_house(foundation, 0.5, &random);
      ASSERT_EQ(house.foundation, foundation);
      ASSERT_TRUE(is_well_formed(house));
      EXPECT_TRUE(is_distinct(house) || flat_parts_are_distinct(house));
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

TEST(RowHouse, IsSevenCellsWideAndNoWiderPartSticksOut) {
  Random random(2);
  for (double gsd : {0.25, 0.5, 1.0}) {
    for (int i = 0; i < 200; ++i) {
      const House house = random_row_house(kRows[i % 3], gsd, &random);
      const auto blocks = expand_blocks(house);
      const Rectangle main = rectangle_of(blocks[0]);
      EXPECT_GE(main.size_x(), std::max(4.0, 7.0 * gsd) - 1e-9);
      EXPECT_LE(main.size_x(), 8.0 + 1e-9);
      for (const auto& block : blocks) {
        EXPECT_GE(block[block_value::kX0], main.x0 - 1e-9);
        EXPECT_LE(block[block_value::kX1], main.x1 + 1e-9);
      }
    }
  }
}

TEST(RowHouse, ExtensionsBelowAGarageAreGarages) {
  Random random(3);
  int garages = 0;
  for (int i = 0; i < 300; ++i) {
    const House house = random_row_house(kRows[i % 3], 0.5, &random);
    for (const Rule& garage : house.garages) {
      ++garages;
      EXPECT_LT(garage[param::garage::kHeightI], kFlatBlockHeight);
    }
    for (size_t k = 1; k < house.roofs.size(); ++k) {
      EXPECT_GE(house.roofs[k][param::roof::kEaves], kFlatBlockHeight);
    }
  }
  EXPECT_GT(garages, 60);
}

TEST(RowHouse, NeighboursShareWholePartyWallsAndCoverNothingOfIt) {
  Random random(4);
  int both = 0;
  constexpr int kHouses = 200;
  for (int i = 0; i < kHouses; ++i) {
    House house = random_row_house(Foundation::kI, 0.5, &random);
    house.garages.clear();
    house.dormers.clear();
    house.chimneys.clear();
    house.origin = {100.0, 200.0, 30.0};
    const BuiltShape beside = random_row_beside(house, &random);
    const BuiltShape own = shape_of(house);
    const Eigen::Vector2d x(std::cos(house.azimuth[0]), std::sin(house.azimuth[0]));
    const double half = 0.5 * rectangle_of(expand_blocks(house)[0]).size_x();
    const Eigen::Vector2d at = house.origin.head<2>();
    int sides = 0;
    for (int side : {-1, 1}) {
      EXPECT_FALSE(std::isfinite(beside.at(at + side * (half - 0.01) * x)));
      sides += std::isfinite(beside.at(at + side * (half + 0.01) * x));
    }
    EXPECT_GE(sides, 1);
    both += sides == 2;
    EXPECT_TRUE(std::isfinite(own.at(at)));
  }
  EXPECT_GT(both, kHouses / 2);
  EXPECT_LT(both, kHouses);
}

}  // namespace
}  // namespace gable
