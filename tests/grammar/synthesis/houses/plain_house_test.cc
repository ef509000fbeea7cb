#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/plain_house.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gable {
namespace {

TEST(PlainHouse, HasTheSizesOfItsKind) {
  struct Sizes {
    PlainKind kind;
    double least_width, most_width, least_length, most_length;
  };
  constexpr Sizes kSizes[] = {{PlainKind::kHouse, 6.0, 9.2, 7.0, 20.0},
                              {PlainKind::kTerrace, 6.0, 9.2, 20.0, 40.0},
                              {PlainKind::kOuthouse, 2.6, 4.5, 3.0, 8.0}};
  Random random(1);
  for (const Sizes& sizes : kSizes) {
    double shortest = 99.0, longest = 0.0;
    for (int i = 0; i < 300; ++i) {
      const House house = random_plain_house(sizes.kind, 0.5, &random);
      ASSERT_EQ(house.foundation, Foundation::kI);
      ASSERT_TRUE(is_well_formed(house));
      const Rectangle r = rectangle_of(expand_blocks(house)[0]);
      EXPECT_GE(r.size_y(), sizes.least_width - 1e-9);
      EXPECT_LE(r.size_y(), sizes.most_width + 1e-9);
      shortest = std::min(shortest, r.size_x());
      longest = std::max(longest, r.size_x());
      for (const Rule* rule : house.derivation()) {
        const auto specs = parameter_specs(rule->kind);
        for (int p = 0; p < rule->size(); ++p) {
          EXPECT_GE((*rule)[p], specs[p].lower - 1e-9) << rule_name(rule->kind) << specs[p].name;
          EXPECT_LE((*rule)[p], specs[p].upper + 1e-9) << rule_name(rule->kind) << specs[p].name;
        }
      }
    }
    EXPECT_GE(shortest, sizes.least_length - 1e-9);
    EXPECT_LE(longest, sizes.most_length + 1e-9);
    EXPECT_GT(longest, 0.95 * sizes.most_length);
  }
}

TEST(PlainHouse, OuthouseIsFourCellsAndAHalfWide) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const House house = random_plain_house(PlainKind::kOuthouse, 1.0, &random);
    const Rectangle r = rectangle_of(expand_blocks(house)[0]);
    EXPECT_GE(std::min(r.size_x(), r.size_y()), 4.5 - 1e-9);
    EXPECT_LE(house.roofs[0][param::roof::kEaves], 3.5);
  }
}

TEST(PlainHouse, TiltKeepsTheMeanHeightOfAFlatRoof) {
  Random random(3);
  int flat = 0;
  for (int i = 0; i < 60; ++i) {
    const House house = random_plain_house(PlainKind::kOuthouse, 0.5, &random);
    BuiltShape shape = shape_of(house);
    const BuiltPart before = shape.parts[0];
    tilt_flat_roof(&random, &shape);
    const BuiltPart& after = shape.parts[0];
    if (before.form != PartForm::kFlat) {
      EXPECT_EQ(after.form, before.form);
      continue;
    }
    ++flat;
    EXPECT_EQ(after.form, PartForm::kMono);
    EXPECT_GT(after.rise, 0.0);
    EXPECT_NEAR(after.at(after.center), before.eaves, 1e-9);
    for (const Eigen::Vector2d& corner : before.ring()) {
      const Eigen::Vector2d in = after.center + 0.999 * (corner - after.center);
      EXPECT_TRUE(std::isfinite(after.at(in)));
    }
  }
  EXPECT_GT(flat, 15);
}

}  // namespace
}  // namespace gable
