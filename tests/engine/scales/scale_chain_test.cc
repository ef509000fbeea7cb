#include <gable/engine/scales/scale_chain.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gable {
namespace {

double energy(const std::vector<int>& labels, const std::vector<double>& unary,
              const std::vector<double>& jump, int num_labels) {
  double sum = 0.0;
  for (size_t i = 0; i < labels.size(); ++i) {
    sum += unary[i * num_labels + labels[i]];
    if (i == 0 || labels[i] == labels[i - 1]) continue;
    if (labels[i] != labels[i - 1] + 1) return std::numeric_limits<double>::infinity();
    sum += jump[i - 1];
  }
  return sum;
}

// The least energy over every sequence of labels, whether allowed or not.
double least_energy(const std::vector<double>& unary, const std::vector<double>& jump, size_t n,
                    int num_labels) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<int> labels(n, 0);
  while (true) {
    least = std::min(least, energy(labels, unary, jump, num_labels));
    size_t digit = 0;
    while (digit < n && ++labels[digit] == num_labels) labels[digit++] = 0;
    if (digit == n) return least;
  }
}

TEST(ScaleChain, FindsTheLeastEnergyOfAllLabelSequences) {
  Random random(3);
  for (int round = 0; round < 300; ++round) {
    const size_t n = random.integer(1, 7);
    const int num_labels = random.integer(1, 4);
    std::vector<double> unary, jump;
    for (size_t i = 0; i < n * num_labels; ++i) unary.push_back(random.uniform(0.0, 2.0));
    for (size_t i = 1; i < n; ++i) jump.push_back(random.uniform(0.0, 1.0));
    const std::vector<int> labels = cheapest_labels(unary, jump, num_labels);
    ASSERT_EQ(labels.size(), n);
    EXPECT_NEAR(energy(labels, unary, jump, num_labels), least_energy(unary, jump, n, num_labels),
                1e-12);
  }
}

TEST(ScaleChain, NeverSkipsAScaleAndNeverFalls) {
  // The unary costs alone ask for 0 0 2 2 1 1.
  const std::vector<double> unary{0, 1, 1, 0, 1, 1, 2, 1, 0, 2, 1, 0, 1, 0, 1, 1, 0, 1};
  const std::vector<int> labels = cheapest_labels(unary, std::vector<double>(5, 0.1), 3);
  EXPECT_EQ(labels, (std::vector<int>{0, 0, 1, 1, 1, 1}));
}

TEST(ScaleChain, StartsAndEndsWhereTheCostsSay) {
  const std::vector<double> unary{5, 5, 0, 5, 5, 0};
  EXPECT_EQ(cheapest_labels(unary, std::vector<double>{1.0}, 3), (std::vector<int>{2, 2}));
  EXPECT_TRUE(cheapest_labels({}, {}, 3).empty());
}

TEST(ScaleChain, RisesWhereRisingIsCheapAndLaterWhereItIsAllTheSame) {
  // Undecided in between.
  const std::vector<double> unary{0, 9, 1, 1, 1, 1, 1, 1, 9, 0};
  EXPECT_EQ(cheapest_labels(unary, std::vector<double>{0.5, 0.2, 0.5, 0.5}, 2),
            (std::vector<int>{0, 0, 1, 1, 1}));
  EXPECT_EQ(cheapest_labels(unary, std::vector<double>(4, 0.5), 2),
            (std::vector<int>{0, 0, 0, 0, 1}));
}

TEST(ScaleChain, MovingAHistogramByOneBinCostsOne) {
  ScaleFeatures a{}, b{};
  a[0] = 1.0f, b[3] = 1.0f;  // centroid distance: three bins
  a[5] = 0.5f, a[6] = 0.5f;  // alignment: half of it by two bins
  b[5] = 0.5f, b[8] = 0.5f;
  a[9] = 1.0f;           // area: without pairs in b
  a[14] = b[14] = 1.0f;  // vertical: equal
  EXPECT_NEAR(feature_distance(a, b), std::sqrt(9.0 + 1.0), 1e-6);
  EXPECT_EQ(feature_distance(a, b), feature_distance(b, a));
  EXPECT_EQ(feature_distance(a, a), 0.0);
}

// One test of the first feature: low is label 0, high label 1 (3 and 0 nats, or 0 and 3), above
// 0.9 label 2.
Forest staircase() {
  Forest forest;
  forest.num_labels = 3;
  forest.roots = {0};
  forest.nodes = {{0.5f, 0, 2}, {0.0f, -1, 0}, {0.9f, 0, 4}, {0.0f, -1, 1}, {0.0f, -1, 2}};
  forest.leaf_costs = {0, 96, 96, 96, 0, 96, 96, 96, 0};
  return forest;
}

std::vector<ScaleFeatures> first_features(const std::vector<float>& values) {
  std::vector<ScaleFeatures> out(values.size(), ScaleFeatures{});
  for (size_t i = 0; i < values.size(); ++i) out[i][0] = values[i];
  return out;
}

TEST(ScaleChain, TheFirstConfigurationOfEachLabelRepresentsItsScale) {
  const auto features = first_features({0.1f, 0.1f, 0.6f, 0.2f, 0.7f, 0.7f, 0.95f, 0.95f});
  const ScaleLabels labels = label_trajectory(features, staircase(), {});
  // Configuration 3 alone does not bring label 0 back: that would be a fall.
  EXPECT_EQ(labels.first, (std::vector<int>{2, 6}));
  EXPECT_EQ(labels.num_configurations, 8);
}

TEST(ScaleChain, AScaleThatIsMissingHasThePlaceOfTheNextOrTheEnd) {
  EXPECT_EQ(label_trajectory(first_features({0.95f, 0.95f}), staircase(), {}).first,
            (std::vector<int>{0, 0}));
  EXPECT_EQ(label_trajectory(first_features({0.1f, 0.6f, 0.6f}), staircase(), {}).first,
            (std::vector<int>{1, 3}));
  EXPECT_EQ(label_trajectory({}, staircase(), {}).first, (std::vector<int>{0, 0}));
}

TEST(ScaleChain, ALargeGammaKeepsOneLabel) {
  ScaleChainOptions options;
  options.gamma = 1000.0;
  const ScaleLabels labels =
      label_trajectory(first_features({0.1f, 0.1f, 0.1f, 0.6f}), staircase(), options);
  EXPECT_EQ(labels.first, (std::vector<int>{4, 4}));
  options.gamma = -1.0;
  EXPECT_EQ(check(options), "gamma must lie in [0, 1000]");
}

}  // namespace
}  // namespace gable
