#include <gable/engine/closing/label_expansion.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace gable {
namespace {

// Sites with random costs, pairs with a random multiple of how far the labels are apart or of 1.
struct RandomProblem {
  LabelProblem problem;
  std::vector<double> apart, differ;

  RandomProblem(uint64_t seed, int num_sites, int num_labels, double charge) {
    Random random(seed);
    problem.num_labels = num_labels;
    for (int i = 0; i < num_sites * num_labels; ++i) {
      problem.data.push_back(random.uniform(0.0, 3.0));
    }
    for (int a = 0; a < num_sites; ++a) {
      for (int b = a + 1; b < num_sites; ++b) {
        if (random.uniform(0.0, 1.0) > 0.5) continue;
        problem.pairs.push_back({a, b});
        apart.push_back(random.uniform(0.0, 1.0));
        differ.push_back(random.uniform(0.0, 1.0));
      }
    }
    if (charge > 0.0) problem.charges.assign(num_labels, charge);
    problem.pair_cost = [this](int pair, int a, int b) {
      return a == b ? 0.0 : differ[pair] + apart[pair] * std::abs(a - b);
    };
  }
  RandomProblem(const RandomProblem&) = delete;
  RandomProblem& operator=(const RandomProblem&) = delete;

  double least() const {
    const int num_sites = problem.num_sites();
    std::vector<int> labels(num_sites, 0);
    double best = std::numeric_limits<double>::infinity();
    for (;;) {
      best = std::min(best, labelling_cost(problem, labels));
      int i = 0;
      while (i < num_sites && ++labels[i] == problem.num_labels) labels[i++] = 0;
      if (i == num_sites) return best;
    }
  }
};

TEST(LabelExpansion, TwoLabelsGetTheOptimum) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const RandomProblem random(seed, 9, 2, 0.0);
    std::vector<int> labels(9, 0);
    const double cost = expand_labels(random.problem, &labels);
    EXPECT_NEAR(cost, random.least(), 1e-9) << "seed " << seed;
    EXPECT_NEAR(cost, labelling_cost(random.problem, labels), 1e-9);
  }
}

TEST(LabelExpansion, SeveralLabelsComeCloseToTheOptimum) {
  int optimal = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const RandomProblem random(seed, 6, 4, 0.0);
    std::vector<int> labels(6, 0);
    const double cost = expand_labels(random.problem, &labels), least = random.least();
    EXPECT_LE(cost, 1.1 * least) << "seed " << seed;
    optimal += cost < least + 1e-9;
  }
  EXPECT_GE(optimal, 54);
}

TEST(LabelExpansion, ChargesNeverMakeItWorseThanTheStartAndMostlyOptimal) {
  int optimal = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const RandomProblem random(seed, 6, 4, 1.5);
    std::vector<int> labels(6, static_cast<int>(seed % 4));
    const double start = labelling_cost(random.problem, labels);
    const double cost = expand_labels(random.problem, &labels), least = random.least();
    EXPECT_LE(cost, start);
    EXPECT_LE(cost, 1.25 * least) << "seed " << seed;
    optimal += cost < least + 1e-9;
  }
  EXPECT_GE(optimal, 45);
}

TEST(LabelExpansion, LabelThatDoesNotPayItsChargeIsGivenUp) {
  LabelProblem problem;
  problem.num_labels = 2;
  problem.data = {0.0, 5.0, 0.0, 5.0, 0.8, 0.0};
  problem.pair_cost = [](int, int, int) { return 0.0; };
  std::vector<int> labels = {0, 0, 1};
  EXPECT_DOUBLE_EQ(expand_labels(problem, &labels), 0.0);
  EXPECT_EQ(labels, (std::vector<int>{0, 0, 1}));
  problem.charges = {1.0, 1.0};
  EXPECT_DOUBLE_EQ(expand_labels(problem, &labels), 1.8);
  EXPECT_EQ(labels, (std::vector<int>{0, 0, 0}));
}

TEST(LabelExpansion, ImpossibleLabelsAreNeverTakenAndSpareOnlyWork) {
  for (uint64_t seed = 0; seed < 40; ++seed) {
    RandomProblem random(seed, 12, 5, 0.7);
    // Two thirds of the labels are out of question at a site; label 0 never is.
    Random choice(seed + 1000);
    for (int i = 0; i < 12; ++i) {
      for (int l = 1; l < 5; ++l) {
        if (choice.uniform(0.0, 1.0) < 0.66) random.problem.data[5 * i + l] = 1e6;
      }
    }
    std::vector<int> all(12, 0), spared(12, 0);
    const double cost = expand_labels(random.problem, &all);
    random.problem.impossible = 1e6;
    EXPECT_NEAR(expand_labels(random.problem, &spared), cost, 1e-9) << "seed " << seed;
    EXPECT_EQ(spared, all) << "seed " << seed;
    for (int i = 0; i < 12; ++i) EXPECT_LT(random.problem.at(i, spared[i]), 1e6);
  }
}

TEST(LabelExpansion, NothingToLabelCostsNothing) {
  LabelProblem problem;
  problem.num_labels = 3;
  std::vector<int> labels;
  EXPECT_EQ(expand_labels(problem, &labels), 0.0);
}

}  // namespace
}  // namespace gable
