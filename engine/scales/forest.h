#pragma once

#include <gable/engine/scales/scale_features.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gable {

/// A node of a decision tree: a test of one feature, or a leaf.
struct ForestNode {
  float threshold = 0.0f;  ///< of a test: features up to it go left
  int16_t feature = -1;    ///< that is tested; -1: a leaf
  /// Of a test: its right child, a number of a node (the left child is the next node). Of a leaf:
  /// its number among the leaves, which rises from node to node.
  int32_t next = 0;
  bool operator==(const ForestNode&) const = default;
};

/// Log-probabilities of leaves are kept in steps of this many nats. A byte then reaches down to a
/// probability of 3.5e-4, and the mean over many trees is off by far less than a step.
inline constexpr double kLeafCostStep = 1.0 / 32.0;

/// A random forest (Breiman, Machine Learning 45, 2001) that tells the labels 0 to num_labels - 1
/// apart. Plain data: equal forests give equal bytes and equal answers.
struct Forest {
  int num_labels = 0;             ///< [1, 64]
  std::vector<int> roots;         ///< one per tree: its first node
  std::vector<ForestNode> nodes;  ///< tree by tree, each in preorder
  /// -log P_t(label | leaf) in steps of kLeafCostStep, num_labels bytes a leaf.
  std::vector<uint8_t> leaf_costs;

  int num_trees() const { return static_cast<int>(roots.size()); }
  bool operator==(const Forest&) const = default;
};

/// Empty if the forest is sound (whole trees in preorder, so every walk ends in a leaf); otherwise
/// says what is not.
std::string check(const Forest& forest);

/// The byte for a probability in (0, 1]. Probabilities below 3.5e-4 count as that.
uint8_t leaf_cost(double probability);

/// The unary term of every label for every configuration, in nats, one configuration after the
/// other, num_labels values each: -1/|T| sum over the trees of log P_t(label | features) (CVPR
/// 2018, eq. 3). The forest must be sound. Sums are of integers, so their order does not matter.
std::vector<double> label_costs(const Forest& forest, std::span<const ScaleFeatures> features);

}  // namespace gable
