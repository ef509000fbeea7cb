#include <ceres/jet.h>
#include <gable/residuals/layered_sample.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "residuals/random_houses.h"

namespace gable {
namespace {

using Jet = ceres::Jet<double, kNumBlockValues * kMaxLayers>;

Block<Jet> independent(const Block<double>& block, int slot) {
  Block<Jet> out;
  out.ridge = block.ridge;
  out.flat = block.flat;
  out.mansard = block.mansard;
  for (int k = 0; k < kNumBlockValues; ++k) {
    out.values[k] = Jet(block[k], slot * kNumBlockValues + k);
  }
  return out;
}

// What is averaged over a sample's layers, both as jets and written out.
struct Averaged {
  const char* name;
  RoofSampling sampling;
  LayerValues (*values)(const SeenLayers&, const RobustLoss&, double ground, double height);
  Jet (*value)(const Jet& layer, const RobustLoss&, double height);
};

const Averaged kCosts = {"costs", RoofSampling::kCentroid, layer_costs,
                         [](const Jet& layer, const RobustLoss& loss, double height) {
                           return loss.cost(layer - height);
                         }};
const Averaged kHeights = {"heights", RoofSampling::kMean,
                           [](const SeenLayers& seen, const RobustLoss&, double ground, double) {
                             return layer_heights(seen, ground);
                           },
                           [](const Jet& layer, const RobustLoss&, double) { return layer; }};

class LayeredMean : public testing::TestWithParam<const Averaged*> {};

TEST_P(LayeredMean, EqualsTheTemplatesWithItsAutomaticDerivatives) {
  const Averaged& averaged = *GetParam();
  Random random(3);
  std::array<int, kMaxLayers + 1> by_count{};
  for (int trial = 0; trial < 3000; ++trial) {
    const House house = rich_house(kAllFoundations[trial % 6], &random);
    const std::vector<Block<double>> blocks = expand_blocks(house);
    const std::vector<ColumnRange> ranges(blocks.size(), ColumnRange{0, 1});
    const double x = random.uniform(-8.0, 8.0), y = random.uniform(-8.0, 8.0);
    const double support = random.uniform(0.3, 3.0), ground = random.uniform(-0.3, 0.3);
    const double height = random.uniform(0.0, 8.0);
    const RobustLoss loss(random.chance(0.5) ? LossKind::kSoftL1 : LossKind::kGemanMcClure, 0.3);
    const SeenLayers seen = seen_layers(blocks, ranges, 0, x, y, support, averaged.sampling);
    ++by_count[seen.count];

    FacetGradients gradients(blocks.size());
    for (size_t b = 0; b < blocks.size(); ++b) {
      for (int f = 0; f < kNumFacets; ++f) {
        gradients[b][f] = facet_gradient(blocks[b], static_cast<Facet>(f));
      }
    }
    const LayerValues values = averaged.values(seen, loss, ground, height);
    std::array<BlockGradient, kMaxLayers> derivatives;
    const double mean = layered_mean(seen, values, support, &gradients, derivatives.data());
    EXPECT_EQ(layered_mean(seen, values, support, nullptr, nullptr), mean);

    std::vector<Block<Jet>> jets;
    for (int k = 0; k < seen.count; ++k) {
      jets.push_back(independent(blocks[seen.layers[k].block], k));
    }
    const Layers<Jet> layers = layers_at<Jet, double>(jets, x, y, support, averaged.sampling);
    Jet expected = layers.ground_share * averaged.value(Jet(ground), loss, height);
    for (int k = 0; k < layers.count; ++k) {
      expected += layers.layers[k].share * averaged.value(layers.layers[k].height, loss, height);
    }
    EXPECT_NEAR(mean, expected.a, 1e-12 * std::max(1.0, std::abs(expected.a)));
    const double largest = std::max(1.0, expected.v.cwiseAbs().maxCoeff());
    for (int k = 0; k < seen.count; ++k) {
      const auto automatic = expected.v.segment<kNumBlockValues>(k * kNumBlockValues);
      EXPECT_LE((derivatives[k] - automatic).cwiseAbs().maxCoeff(), 1e-12 * largest)
          << seen.count << " layers, layer " << k;
    }
  }
  for (int n : by_count) EXPECT_GT(n, 50);  // every number of layers was met
}

INSTANTIATE_TEST_SUITE_P(Of, LayeredMean, testing::Values(&kCosts, &kHeights),
                         [](const auto& instance) { return instance.param->name; });

TEST(LayeredSample, SeesTheLayersOfTheHeightField) {
  Random random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const std::vector<Block<double>> blocks =
        expand_blocks(rich_house(kAllFoundations[trial % 6], &random));
    const std::vector<ColumnRange> ranges(blocks.size(), ColumnRange{0, 1});
    const double x = random.uniform(-8.0, 8.0), y = random.uniform(-8.0, 8.0);
    const SeenLayers seen = seen_layers(blocks, ranges, 0, x, y, 1.0, RoofSampling::kCentroid);
    const Layers<double> all = layers_at<double, double>(blocks, x, y, 1.0);
    ASSERT_LE(seen.count, all.count);
    for (int k = 0; k < all.count; ++k) {
      if (k >= seen.count) {
        EXPECT_NEAR(all.layers[k].share, 0.0, 1e-14);  // hidden below a whole one
        continue;
      }
      EXPECT_EQ(seen.layers[k].block, all.layers[k].block);
      EXPECT_NEAR(seen.layers[k].height, all.layers[k].height, 1e-13);
    }
  }
}

}  // namespace
}  // namespace gable
