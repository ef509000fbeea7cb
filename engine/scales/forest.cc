#include <gable/engine/scales/forest.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gable {

std::string check(const Forest& forest) {
  if (forest.num_labels < 1 || forest.num_labels > 64) return "num_labels must lie in [1, 64]";
  if (forest.roots.empty()) return "there is no tree";
  const int num_nodes = static_cast<int>(forest.nodes.size());
  int num_leaves = 0;
  int end = 0;  // of the trees so far
  for (const int root : forest.roots) {
    if (root != end) return "a tree must begin where the one before it ends";
    std::vector<int> right;  // children whose left siblings' trees are not over yet
    int i = root;
    for (bool whole = false; !whole; ++i) {
      if (i >= num_nodes) return "the last tree is not whole";
      const ForestNode& node = forest.nodes[i];
      if (node.feature >= kNumFeatures) return "a test looks at a feature that does not exist";
      if (node.feature >= 0) {
        if (!std::isfinite(node.threshold)) return "a threshold is not finite";
        right.push_back(node.next);
        continue;
      }
      if (node.next != num_leaves++) return "leaves must be numbered in the order of their nodes";
      whole = right.empty();
      if (whole) continue;
      if (right.back() != i + 1) return "a right child must follow what lies below the left one";
      right.pop_back();
    }
    end = i;
  }
  if (end != num_nodes) return "there are nodes behind the last tree";
  if (forest.leaf_costs.size() != static_cast<size_t>(num_leaves) * forest.num_labels) {
    return "leaf_costs must hold num_labels bytes a leaf";
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
