#include <gable/engine/reconstruct/choice/derivation_rewrites.h>
#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr double kHalf = 14.0;  // of the square that surfaces are compared in, metres

// Roofs of one pitch, 0.7, over eaves of 4 m; `start` and `end`: runs of hips as shares.
RoofedRectangle pitched(double x0, double x1, double y0, double y1, Axis ridge, double start,
                        double end) {
  const double width = ridge == Axis::kX ? y1 - y0 : x1 - x0;
  return {x0, x1, y0, y1, hip_roof(4.0, 0.35 * width, start, end, ridge)};
}

RoofedRectangle mirrored(RoofedRectangle r, bool x, bool y, bool diagonal) {
  const auto swap_hips = [&] {
    std::swap(r.roof[param::roof::kHipStart], r.roof[param::roof::kHipEnd]);
  };
  if (x) {
    r = {-r.x1, -r.x0, r.y0, r.y1, r.roof};
    if (r.roof.ridge == Axis::kX) swap_hips();
  }
  if (y) {
    r = {r.x0, r.x1, -r.y1, -r.y0, r.roof};
    if (r.roof.ridge == Axis::kY) swap_hips();
  }
  if (diagonal) {
    r = {r.y0, r.y1, r.x0, r.x1, r.roof};
    r.roof.ridge = r.roof.ridge == Axis::kX ? Axis::kY : Axis::kX;
  }
  return r;
}

// A hipped base 16 m by 7 m and a wing 5 m wide that ends under the base's ridge.
const RoofedRectangle kBase = pitched(-8.0, 8.0, -6.0, 1.0, Axis::kX, 3.5 / 16, 3.5 / 16);
const RoofedRectangle kLeft = pitched(-8.0, -3.0, -2.5, 9.0, Axis::kY, 0.0, 0.2);
const RoofedRectangle kRight = pitched(3.5, 8.0, -2.5, 7.0, Axis::kY, 0.0, 0.25);

double least_difference(const House& house, const std::vector<House>& others, Foundation type) {
  double least = 1e9;
  for (const House& other : others) {
    EXPECT_TRUE(is_well_formed(other));
    if (other.foundation != type) continue;
    least = std::min(least, surface_difference(house, other, kHalf, 31));
  }
  return least;
}

TEST(DerivationRewrites, TwoBlocksAtACornerAreAnLOfTheSameSurface) {
  for (int turn = 0; turn < 8; ++turn) {
    const auto at = [&](const RoofedRectangle& r) {
      return mirrored(r, turn & 1, turn & 2, turn & 4);
    };
    House house = blocks_house({at(kBase), at(kLeft)}, 0.4);
    house.origin = {100.0, 200.0, 30.0};
    const std::vector<House> others = rewrites(house, {});
    EXPECT_LT(least_difference(house, others, Foundation::kL), 1e-9) << "turn " << turn;
    for (const House& other : others) EXPECT_EQ(other.origin, house.origin);
    // The order of the blocks does not matter.
    const House reversed = blocks_house({at(kLeft), at(kBase)}, 0.4);
    EXPECT_LT(least_difference(reversed, rewrites(reversed, {}), Foundation::kL), 1e-9);
  }
}

TEST(DerivationRewrites, ThreeBlocksAroundAYardAreAUOfTheSameSurface) {
  for (int turn = 0; turn < 8; ++turn) {
    std::vector<RoofedRectangle> blocks = {kBase, kLeft, kRight};
    for (RoofedRectangle& r : blocks) r = mirrored(r, turn & 1, turn & 2, turn & 4);
    for (int order = 0; order < 3; ++order) {
      const House house = blocks_house(blocks, 0.4);
      EXPECT_LT(least_difference(house, rewrites(house, {}), Foundation::kU), 1e-9)
          << "turn " << turn << ", order " << order;
      std::rotate(blocks.begin(), blocks.begin() + 1, blocks.end());
    }
  }
}

TEST(DerivationRewrites, DetailsStayWhereTheyAre) {
  for (int turn = 0; turn < 8; ++turn) {
    const auto at = [&](const RoofedRectangle& r) {
      return mirrored(r, turn & 1, turn & 2, turn & 4);
    };
    House house = blocks_house({at(kBase), at(kLeft)}, 0.4);
    const RoofedRectangle& base = at(kBase);
    const double x = 0.5 * (base.x0 + base.x1), y = 0.5 * (base.y0 + base.y1);
    const bool along_x = base.roof.ridge == Axis::kX;
    Rule chimney = make_rule(RuleKind::kChimney);
    chimney.values = {x, y, 0.8, 9.0};
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = 0;
    dormer.values = {x + (along_x ? 1.0 : 1.8), y + (along_x ? 1.8 : 1.0), 2.2, 2.6, 5.5, 0.5};
    Rule garage = make_rule(RuleKind::kGarageI);
    garage.values = {along_x ? x : base.x0 - 2.0, along_x ? base.y0 - 2.0 : y, along_x ? 5.0 : 4.0,
                     along_x ? 4.0 : 5.0, 2.6};
    house.chimneys = {chimney};
    house.dormers = {dormer};
    house.garages = {garage};
    const std::vector<House> others = rewrites(house, {});
    EXPECT_LT(least_difference(house, others, Foundation::kL), 1e-9) << "turn " << turn;
    for (const House& other : others) {
      EXPECT_EQ(other.chimneys.size(), 1u);
      EXPECT_EQ(other.dormers.size(), 1u);
      EXPECT_EQ(other.garages.size(), 1u);
    }
  }
}

TEST(DerivationRewrites, ALowFlatBlockIsAGarageOfTheSameSurface) {
  // It reaches 0.5 m under the base, where it is not seen.
  const RoofedRectangle low{7.5, 12.0, -4.0, -1.0, flat_roof(2.6)};
  const House two = blocks_house({kBase, low}, 0.4);
  const std::vector<House> others = rewrites(two, {});
  EXPECT_LT(least_difference(two, others, Foundation::kI), 1e-9);
  ASSERT_EQ(others.size(), 1u);
  ASSERT_EQ(others[0].garages.size(), 1u);
  // What stands under the base is cut off.
  const std::array<double, 5> garage = {10.0, -2.5, 4.0, 3.0, 2.6};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(others[0].garages[0][k], garage[k], 1e-9);

  // Three blocks: a II with a garage, and an L with one.
  const House three = blocks_house({low, kBase, kLeft}, 0.4);
  const std::vector<House> more = rewrites(three, {});
  EXPECT_LT(least_difference(three, more, Foundation::kII), 1e-9);
  EXPECT_LT(least_difference(three, more, Foundation::kL), 1e-9);
}

TEST(DerivationRewrites, AFlatBlockOfAStoreysHeightIsNoGarage) {
  RewriteOptions options;
  const House two = blocks_house({kBase, {8.0, 12.0, -4.0, -1.0, flat_roof(4.0)}}, 0.4);
  EXPECT_TRUE(rewrites(two, options).empty());
  options.garage_height = 4.5;
  EXPECT_EQ(rewrites(two, options).size(), 1u);
}

TEST(DerivationRewrites, FreeBlocksAreNothingElse) {
  // Apart from each other; side by side; a T; a wing that meets the base beyond the alignment.
  const RoofedRectangle apart = pitched(-8.0, -3.0, 4.0, 12.0, Axis::kY, 0.0, 0.2);
  const RoofedRectangle beside = pitched(8.0, 12.0, -6.0, 1.0, Axis::kX, 0.0, 0.2);
  const RoofedRectangle middle = pitched(-2.0, 3.0, -2.5, 9.0, Axis::kY, 0.0, 0.2);
  for (const RoofedRectangle& other : {apart, beside, middle}) {
    EXPECT_TRUE(rewrites(blocks_house({kBase, other}, 0.4), {}).empty());
  }
  EXPECT_TRUE(rewrites(blocks_house({kBase, kLeft, middle}, 0.4), {}).empty());
  EXPECT_TRUE(rewrites(blocks_house({kBase}, 0.4), {}).empty());
}

TEST(DerivationRewrites, AlignmentSaysHowFarEdgesMayBeApart) {
  RoofedRectangle off = kLeft;
  off.x0 += 1.5;
  off.x1 += 1.5;
  RewriteOptions options;
  options.alignment = 1.0;
  const RoofedRectangle low{8.0, 12.0, -4.0, -1.0, flat_roof(2.6)};
  const auto count_ls = [&](const std::vector<RoofedRectangle>& blocks) {
    const std::vector<House> others = rewrites(blocks_house(blocks, 0.4), options);
    return std::count_if(others.begin(), others.end(),
                         [](const House& h) { return h.foundation == Foundation::kL; });
  };
  EXPECT_EQ(count_ls({kBase, off}), 0);
  EXPECT_EQ(count_ls({kBase, off, low}), 0);
  options.alignment = 2.0;
  EXPECT_GE(count_ls({kBase, off}), 1);
  EXPECT_GE(count_ls({kBase, off, low}), 1);
}

}  // namespace
}  // namespace gable
