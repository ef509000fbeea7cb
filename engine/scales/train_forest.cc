#include <gable/engine/scales/train_forest.h>
#include <gable/grammar/random.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>

namespace gable {
namespace {

struct Samples {
  std::vector<ScaleFeatures> features;
  std::vector<int> labels;
  std::vector<float> weights;  ///< their mean is 1
};

Samples choose_samples(const std::vector<LabelledTrajectory>& trajectories, int num_scales,
                       const ForestTrainingOptions& options) {
  Samples samples;
  double total = 0.0;
  std::vector<double> weights;
  for (const LabelledTrajectory& trajectory : trajectories) {
    CHECK_EQ(trajectory.features.size(), trajectory.labels.size());
    std::map<int, std::vector<size_t>> of_label;
    for (size_t i = 0; i < trajectory.labels.size(); ++i) {
      CHECK(trajectory.labels[i] >= 0 && trajectory.labels[i] <= num_scales)
          << trajectory.labels[i];
      of_label[trajectory.labels[i]].push_back(i);
    }
    for (const auto& [label, members] : of_label) {
      const size_t n = members.size();
      const size_t used = std::min<size_t>(n, options.max_samples_per_label);
      const double weight = std::pow(n, 1.0 - options.balance) / used;
      for (size_t i = 0; i < used; ++i) {
        const size_t member = members[used == 1 ? 0 : i * (n - 1) / (used - 1)];
        samples.features.push_back(trajectory.features[member]);
        samples.labels.push_back(label);
        weights.push_back(weight);
        total += weight;
      }
    }
  }
  CHECK(!samples.labels.empty()) << "a forest needs at least one configuration";
  for (const double weight : weights) {
    samples.weights.push_back(static_cast<float>(weight * weights.size() / total));
  }
  return samples;
}

// OpenCV draws bootstrap samples and features from its generator of the calling thread.
class SeededOpenCv {
 public:
  explicit SeededOpenCv(uint64_t seed) : before_(cv::theRNG()) { cv::theRNG() = cv::RNG(seed); }
  ~SeededOpenCv() { cv::theRNG() = before_; }
  SeededOpenCv(const SeededOpenCv&) = delete;
  SeededOpenCv& operator=(const SeededOpenCv&) = delete;

 private:
  cv::RNG before_;
};

cv::Ptr<cv::ml::RTrees> grow(const Samples& samples, const ForestTrainingOptions& options) {
  const int n = static_cast<int>(samples.labels.size());
  cv::Mat features(n, kNumFeatures, CV_32F), labels(samples.labels), weights(samples.weights);
  for (int i = 0; i < n; ++i) {
    std::copy(samples.features[i].begin(), samples.features[i].end(), features.ptr<float>(i));
  }
  const auto trees = cv::ml::RTrees::create();
  trees->setMaxDepth(options.max_depth);
  trees->setMinSampleCount(options.min_samples);
  trees->setActiveVarCount(options.features_per_split);
  trees->setCVFolds(0);
  trees->setTermCriteria({cv::TermCriteria::COUNT, options.num_trees, 0.0});
  const SeededOpenCv seeded(Random(options.seed).next());
  trees->train(cv::ml::TrainData::create(features, cv::ml::ROW_SAMPLE, labels, {}, {}, weights));
  return trees;
}

// Appends an OpenCV node and what lies below it, in preorder.
void append(const cv::ml::RTrees& trees, int at, int* num_leaves, Forest* forest) {
  const cv::ml::DTrees::Node& node = trees.getNodes()[at];
  const size_t index = forest->nodes.size();
  if (node.split < 0) {
    forest->nodes.push_back({0.0f, -1, (*num_leaves)++});
    return;
  }
  const cv::ml::DTrees::Split& split = trees.getSplits()[node.split];
  forest->nodes.push_back({split.c, static_cast<int16_t>(split.varIdx), 0});
  append(trees, node.left, num_leaves, forest);
  forest->nodes[index].next = static_cast<int32_t>(forest->nodes.size());
  append(trees, node.right, num_leaves, forest);
}

void fill_leaves(const Samples& samples, int num_leaves, double smoothing, Forest* forest) {
  const int labels = forest->num_labels;
  std::vector<double> frequencies(labels, 1.0);  // a label without samples keeps a little
  double total = labels;
  for (size_t i = 0; i < samples.labels.size(); ++i) {
    frequencies[samples.labels[i]] += samples.weights[i];
    total += samples.weights[i];
  }
  std::vector<double> counts(static_cast<size_t>(num_leaves) * labels);
  for (size_t k = 0; k < counts.size(); ++k) {
    counts[k] = smoothing * frequencies[k % labels] / total;
  }
  for (const int root : forest->roots) {
    for (size_t i = 0; i < samples.labels.size(); ++i) {
      int at = root;
      while (forest->nodes[at].feature >= 0) {
        const ForestNode& node = forest->nodes[at];
        at = samples.features[i][node.feature] <= node.threshold ? at + 1 : node.next;
      }
      counts[static_cast<size_t>(forest->nodes[at].next) * labels + samples.labels[i]] +=
          samples.weights[i];
    }
  }
  for (int leaf = 0; leaf < num_leaves; ++leaf) {
    const double* begin = &counts[static_cast<size_t>(leaf) * labels];
    double sum = 0.0;
    for (int label = 0; label < labels; ++label) sum += begin[label];
    for (int label = 0; label < labels; ++label) {
      forest->leaf_costs.push_back(leaf_cost(std::min(1.0, begin[label] / sum)));
    }
  }
}

}  // namespace

std::string check(const ForestTrainingOptions& options) {
  const auto outside = [](double value, double low, double high) {
    return !(value >= low && value <= high);
  };
  if (outside(options.num_trees, 1, 1000)) return "num_trees must lie in [1, 1000]";
  if (outside(options.max_depth, 1, 25)) return "max_depth must lie in [1, 25]";
  if (outside(options.min_samples, 2, 1e6)) return "min_samples must lie in [2, 1e6]";
  if (outside(options.features_per_split, 1, kNumFeatures)) {
    return "features_per_split must lie in [1, 18]";
  }
  if (outside(options.max_samples_per_label, 2, 1e9)) {
    return "max_samples_per_label must lie in [2, 1e9]";
  }
  if (outside(options.balance, 0.0, 1.0)) return "balance must lie in [0, 1]";
  if (!(options.smoothing > 0.0 && options.smoothing <= 1000.0)) {
    return "smoothing must lie in (0, 1000]";
  }
  return "";
}

Forest train_forest(const std::vector<LabelledTrajectory>& trajectories, int num_scales,
                    const ForestTrainingOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK(num_scales >= 1 && num_scales <= 63) << num_scales;
  const Samples samples = choose_samples(trajectories, num_scales, options);
  Forest forest;
  forest.num_labels = num_scales + 1;
  int num_leaves = 0;
  const auto [least, most] = std::minmax_element(samples.labels.begin(), samples.labels.end());
  if (*least == *most) {
    // Nothing to tell apart, which OpenCV refuses: one tree of one leaf.
    forest.roots = {0};
    forest.nodes = {{0.0f, -1, num_leaves++}};
  } else {
    const auto trees = grow(samples, options);
    for (const int root : trees->getRoots()) {
      forest.roots.push_back(static_cast<int>(forest.nodes.size()));
      append(*trees, root, &num_leaves, &forest);
    }
  }
  fill_leaves(samples, num_leaves, options.smoothing, &forest);
  CHECK(check(forest).empty()) << check(forest);
  return forest;
}

}  // namespace gable
