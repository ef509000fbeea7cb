#include <gable/engine/scales/train_forest.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>
#include <thread>

namespace gable {
namespace {

// Histograms that drift along a trajectory and change their drift with the label.
LabelledTrajectory synthetic_trajectory(uint64_t seed, const std::vector<int>& counts,
                                        double noise = 0.05) {
  Random random(seed);
  LabelledTrajectory out;
  for (size_t label = 0; label < counts.size(); ++label) {
    for (int i = 0; i < counts[label]; ++i) {
      ScaleFeatures features;
      for (int k = 0; k < kNumFeatures; ++k) {
        const double mean =
            0.2 + 0.1 * std::sin(1.0 + k * (label + 1.0)) + 0.02 * i / counts[label];
        features[k] = static_cast<float>(mean + random.normal(noise));
      }
      out.features.push_back(features);
      out.labels.push_back(static_cast<int>(label));
    }
  }
  return out;
}

std::vector<int> best_labels(const Forest& forest, const std::vector<ScaleFeatures>& features) {
  const std::vector<double> costs = label_costs(forest, features);
  std::vector<int> out;
  for (size_t i = 0; i < features.size(); ++i) {
    const auto begin = costs.begin() + i * forest.num_labels;
    out.push_back(static_cast<int>(std::min_element(begin, begin + forest.num_labels) - begin));
  }
  return out;
}

double agreement(const std::vector<int>& a, const std::vector<int>& b) {
  double same = 0.0;
  for (size_t i = 0; i < a.size(); ++i) same += a[i] == b[i];
  return same / a.size();
}

TEST(TrainForest, TellsLabelsApartOnTrajectoriesItHasNotSeen) {
  std::vector<LabelledTrajectory> training;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    training.push_back(synthetic_trajectory(seed, {100, 50, 30, 10}));
  }
  ForestTrainingOptions options;
  options.num_trees = 50;
  const Forest forest = train_forest(training, 3, options);
  EXPECT_EQ(forest.num_labels, 4);
  EXPECT_EQ(forest.num_trees(), 50);
  const LabelledTrajectory unseen = synthetic_trajectory(99, {100, 50, 30, 10});
  EXPECT_GT(agreement(best_labels(forest, unseen.features), unseen.labels), 0.95);
}

TEST(TrainForest, AgreesWithTheVoteOfTheTreesItIsReadFrom) {
  const LabelledTrajectory training = synthetic_trajectory(7, {300, 300, 300}, 0.08);
  const LabelledTrajectory unseen = synthetic_trajectory(8, {300, 300, 300}, 0.08);
  ForestTrainingOptions options;
  options.balance = 0.0;
  const Forest forest = train_forest({training}, 2, options);

  const auto matrix = [](const std::vector<ScaleFeatures>& features) {
    cv::Mat out(static_cast<int>(features.size()), kNumFeatures, CV_32F);
    for (int i = 0; i < out.rows; ++i) {
      std::copy(features[i].begin(), features[i].end(), out.ptr<float>(i));
    }
    return out;
  };
  const auto trees = cv::ml::RTrees::create();
  trees->setMaxDepth(options.max_depth);
  trees->setMinSampleCount(options.min_samples);
  trees->setActiveVarCount(options.features_per_split);
  trees->setCVFolds(0);
  trees->setTermCriteria({cv::TermCriteria::COUNT, options.num_trees, 0.0});
  trees->train(matrix(training.features), cv::ml::ROW_SAMPLE, cv::Mat(training.labels));
  cv::Mat predicted;
  trees->predict(matrix(unseen.features), predicted);
  std::vector<int> vote;
  for (int i = 0; i < predicted.rows; ++i) vote.push_back(std::lround(predicted.at<float>(i)));
  const std::vector<int> ours = best_labels(forest, unseen.features);
  EXPECT_GT(agreement(ours, vote), 0.97);
  EXPECT_NEAR(agreement(ours, unseen.labels), agreement(vote, unseen.labels), 0.015);
  EXPECT_LT(agreement(vote, unseen.labels), 0.999) << "too easy to show anything";
}

TEST(TrainForest, TheSeedAloneDecidesWhateverTheThreadAndWhateverWasDrawnBefore) {
  const LabelledTrajectory training = synthetic_trajectory(1, {80, 80, 80}, 0.1);
  ForestTrainingOptions options;
  options.num_trees = 20;
  const Forest forest = train_forest({training}, 2, options);
  cv::setRNGSeed(1234);
  const cv::RNG before = cv::theRNG();
  const int threads = cv::getNumThreads();
  cv::setNumThreads(threads == 1 ? 2 : 1);
  EXPECT_EQ(train_forest({training}, 2, options), forest);
  cv::setNumThreads(threads);
  EXPECT_EQ(cv::theRNG().state, before.state) << "the caller's generator has moved";
  std::vector<Forest> others(3);
  std::vector<std::thread> pool;
  for (Forest& other : others) {
    pool.emplace_back([&] { other = train_forest({training}, 2, options); });
  }
  for (std::thread& thread : pool) thread.join();
  for (const Forest& other : others) EXPECT_EQ(other, forest);
  options.seed = 2;
  EXPECT_NE(train_forest({training}, 2, options), forest);
}

TEST(TrainForest, LeavesHoldTheSmoothedDistributionOfAllSamplesThatReachThem) {
  // The labels cannot be told apart: all features are equal, so every tree is one leaf.
  LabelledTrajectory training;
  training.features.assign(10, ScaleFeatures{});
  training.labels = {0, 0, 0, 0, 0, 0, 0, 1, 1, 1};
  ForestTrainingOptions options;
  options.num_trees = 3;
  options.balance = 0.0;
  options.smoothing = 2.0;
  const Forest forest = train_forest({training}, 2, options);
  // Frequencies with one sample more of each label: 8/13, 4/13, 1/13.
  const std::vector<double> expected{(7 + 2 * 8 / 13.0) / 12, (3 + 2 * 4 / 13.0) / 12,
                                     (0 + 2 * 1 / 13.0) / 12};
  const std::vector<double> costs = label_costs(forest, training.features);
  for (int label = 0; label < 3; ++label) {
    EXPECT_NEAR(costs[label], -std::log(expected[label]), 0.5 * kLeafCostStep);
  }
}

TEST(TrainForest, BalanceDecidesWhatManyLikeConfigurationsWeigh) {
  LabelledTrajectory training;
  training.features.assign(100, ScaleFeatures{});
  training.labels.assign(100, 0);
  std::fill(training.labels.begin() + 90, training.labels.end(), 1);
  ForestTrainingOptions options;
  options.num_trees = 2;
  options.smoothing = 1e-3;
  const auto odds = [&](double balance, int cap) {  // of label 0 against label 1
    options.balance = balance;
    options.max_samples_per_label = cap;
    const std::vector<double> costs =
        label_costs(train_forest({training}, 1, options), {training.features.data(), 1});
    return std::exp(costs[1] - costs[0]);
  };
  for (const int cap : {2, 20, 1000}) {
    EXPECT_NEAR(odds(0.0, cap), 9.0, 9.0 * 0.03);
    EXPECT_NEAR(odds(0.5, cap), 3.0, 3.0 * 0.03);
    EXPECT_NEAR(odds(1.0, cap), 1.0, 1.0 * 0.03);
  }
}

TEST(TrainForest, OneLabelAloneIsAlwaysTheAnswer) {
  LabelledTrajectory training = synthetic_trajectory(1, {20});
  std::fill(training.labels.begin(), training.labels.end(), 2);
  const Forest forest = train_forest({training}, 3, {});
  EXPECT_EQ(best_labels(forest, training.features), std::vector<int>(20, 2));
}

TEST(TrainForest, NamesTheViolatedBound) {
  ForestTrainingOptions options;
  EXPECT_EQ(check(options), "");
  options.num_trees = 0;
  EXPECT_EQ(check(options), "num_trees must lie in [1, 1000]");
  options = {};
  options.balance = 1.5;
  EXPECT_EQ(check(options), "balance must lie in [0, 1]");
  options = {};
  options.smoothing = 0.0;
  EXPECT_EQ(check(options), "smoothing must lie in (0, 1000]");
}

}  // namespace
}  // namespace gable
