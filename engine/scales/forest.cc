#include <gable/engine/scales/forest.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gable {

std::string check(const Forest& forest) {
  if (forest.num_labels < 1 || forest.num_labels > 64) return "num_labels must lie in [1, 64]";
  if (forest.roots.empty()) return "there is no tree";
  const int num_nodes = static_cast<int>(forest.nodes.size());
  const int num_leaves = static_cast<int>(forest.leaf_costs.size()) / forest.num_labels;
  if (forest.leaf_costs.size() != static_cast<size_t>(num_leaves) * forest.num_labels) {
    return "leaf_costs must hold num_labels bytes a leaf";
  }
  for (size_t tree = 0; tree < forest.roots.size(); ++tree) {
    const int begin = forest.roots[tree];
    const int end = tree + 1 < forest.roots.size() ? forest.roots[tree + 1] : num_nodes;
    if (begin < 0 || begin >= end || end > num_nodes) return "roots must rise within the nodes";
    for (int i = begin; i < end; ++i) {
      const ForestNode& node = forest.nodes[i];
      if (node.feature < 0) {
        if (node.next < 0 || node.next >= num_leaves) return "a leaf is not among the leaves";
      } else if (node.feature >= kNumFeatures) {
        return "a test looks at a feature that does not exist";
      } else if (!std::isfinite(node.threshold)) {
        return "a threshold is not finite";
      } else if (node.next <= i + 1 || node.next >= end) {
        return "a right child must lie behind the left one, in the same tree";
      }
    }
  }
  return "";
}

uint8_t leaf_cost(double probability) {
  CHECK(probability > 0.0 && probability <= 1.0) << probability;
  return static_cast<uint8_t>(std::min(255.0, std::round(-std::log(probability) / kLeafCostStep)));
}

std::vector<double> label_costs(const Forest& forest, std::span<const ScaleFeatures> features) {
  const int labels = forest.num_labels;
  std::vector<uint32_t> sums(features.size() * labels, 0);
  // Tree by tree, so that a tree stays in the cache while all configurations pass through it.
  for (const int root : forest.roots) {
    for (size_t i = 0; i < features.size(); ++i) {
      int at = root;
      while (forest.nodes[at].feature >= 0) {
        const ForestNode& node = forest.nodes[at];
        at = features[i][node.feature] <= node.threshold ? at + 1 : node.next;
      }
      const uint8_t* costs =
          &forest.leaf_costs[static_cast<size_t>(forest.nodes[at].next) * labels];
      for (int label = 0; label < labels; ++label) sums[i * labels + label] += costs[label];
    }
  }
  std::vector<double> out(sums.size());
  const double scale = kLeafCostStep / forest.num_trees();
  std::transform(sums.begin(), sums.end(), out.begin(), [&](uint32_t s) { return s * scale; });
  return out;
}

}  // namespace gable
