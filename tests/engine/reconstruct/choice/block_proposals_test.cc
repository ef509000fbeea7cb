#include <gable/engine/reconstruct/choice/block_proposals.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/house_image.h"
#include "engine/reconstruct/many_block_shapes.h"

namespace gable {
namespace {

// The proposals for `seen`, where `house` is what was found so far.
std::vector<BlockProposal> proposals(const House& seen, const House& house, double noise = 0.1,
                                     uint64_t seed = 1, BlockProposalOptions options = {}) {
  const HeightImage image = image_of(seen, {.size = 72, .noise = noise, .seed = seed});
  return propose_blocks(rectify(image, house.azimuth[0], 0.5, 1.5), house, options);
}

void expect_near(const RoofedRectangle& a, const RoofedRectangle& b, double tolerance) {
  EXPECT_NEAR(a.x0, b.x0, tolerance);
  EXPECT_NEAR(a.x1, b.x1, tolerance);
  EXPECT_NEAR(a.y0, b.y0, tolerance);
  EXPECT_NEAR(a.y1, b.y1, tolerance);
}

TEST(BlockProposals, AWingThatIsMissingIsProposedWhereItStands) {
  const House seen = t_shape();
  const std::vector<RoofedRectangle> blocks = roofed_rectangles(seen);
  const auto found = proposals(seen, blocks_house({blocks[0]}, seen.azimuth[0]));
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found[0].blocks.size(), 2u);
  EXPECT_EQ(found[0].changed, std::vector<int>{1});
  expect_near(found[0].blocks[0], blocks[0], 1e-9);
  RoofedRectangle outside = blocks[1];
  outside.y1 = blocks[0].y0;
  expect_near(found[0].blocks[1], outside, 0.8);
  EXPECT_EQ(found[0].blocks[1].roof.ridge, Axis::kY);
  EXPECT_NEAR(found[0].blocks[1].roof[param::roof::kEaves], 4.2, 0.4);
}

TEST(BlockProposals, ARowWhoseEavesStepIsCutAtTheStep) {
  const RoofedRectangle low{-8.0, 1.0, -4.0, 4.0, gable_roof(4.0, 3.0, Axis::kX)};
  const RoofedRectangle high{1.0, 8.0, -4.0, 4.0, gable_roof(5.6, 3.0, Axis::kX)};
  const RoofedRectangle both{-8.0, 8.0, -4.0, 4.0, gable_roof(4.7, 3.0, Axis::kX)};
  const auto found = proposals(blocks_house({low, high}, 0.3), blocks_house({both}, 0.3));
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found[0].blocks.size(), 2u);
  expect_near(found[0].blocks[0], low, 0.6);
  expect_near(found[0].blocks[1], high, 0.6);
  EXPECT_NEAR(found[0].blocks[0].roof[param::roof::kEaves], 4.0, 0.3);
  EXPECT_NEAR(found[0].blocks[1].roof[param::roof::kEaves], 5.6, 0.3);
}

TEST(BlockProposals, AComponentOverOpenGroundGivesThatPartUp) {
  const RoofedRectangle real{-8.0, 2.0, -4.0, 4.0, gable_roof(5.0, 3.0, Axis::kX)};
  RoofedRectangle large = real;
  large.x1 = 8.0;
  const auto found = proposals(blocks_house({real}, 0.3), blocks_house({large}, 0.3));
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found[0].blocks.size(), 1u);
  EXPECT_EQ(found[0].changed, std::vector<int>{0});
  expect_near(found[0].blocks[0], real, 0.6);
}

TEST(BlockProposals, NothingIsProposedForAPerfectModelUnderNoise) {
  for (const ManyBlockShape& shape : many_block_shapes()) {
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      EXPECT_TRUE(proposals(shape.house, shape.house, 0.15, seed).empty()) << shape.name;
    }
  }
}

TEST(BlockProposals, WallsThatAreACellOffAreNoBlocks) {
  const House seen = box_house(16.0, 9.0, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  const House small = box_house(15.2, 8.2, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  const House large = box_house(16.8, 9.8, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  EXPECT_TRUE(proposals(seen, small).empty());
  EXPECT_TRUE(proposals(seen, large).empty());
}

TEST(BlockProposals, HaveNoMoreBlocksThanAllowed) {
  const House seen = t_shape();
  const House house = blocks_house({roofed_rectangles(seen)[0]}, seen.azimuth[0]);
  BlockProposalOptions options;
  options.most_blocks = 1;
  for (const BlockProposal& proposal : proposals(seen, house, 0.1, 1, options)) {
    EXPECT_EQ(proposal.blocks.size(), 1u);
  }
}

TEST(BlockProposals, ASmallThingIsNoBlock) {
  House seen = box_house(14.0, 9.0, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  const House bare = seen;
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {2.0, 0.5, 1.5, 10.0};
  seen.chimneys = {chimney};
  EXPECT_TRUE(proposals(seen, bare).empty());
}

}  // namespace
}  // namespace gable
