#include <gable/engine/scales/train_scales.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <numeric>

namespace gable {
namespace {

struct Examples {
  std::vector<std::vector<ScaleFeatures>> trajectories;
  std::vector<ScaleLabels> known;
};

// Trajectories of two scales whose features leave no doubt but for a share of the configurations.
Examples examples(int count, double doubt, uint64_t seed) {
  Random random(seed);
  Examples out;
  for (int t = 0; t < count; ++t) {
    ScaleLabels known;
    known.num_configurations = random.integer(30, 60);
    known.first = {0, random.integer(10, 20)};
    std::vector<ScaleFeatures> features;
    for (int label : known.labels()) {
      ScaleFeatures f{};
      const bool doubtful = random.chance(doubt);
      f[0] = static_cast<float>(doubtful ? random.uniform(0.0, 1.0) : 0.4 * label);
      f[1] = 1.0f - f[0];
      features.push_back(f);
    }
    out.trajectories.push_back(features);
    out.known.push_back(known);
  }
  return out;
}

TEST(TrainScales, LearnsWhatFeaturesTell) {
  const Examples given = examples(30, 0.0, 1);
  const ScaleTraining training = train_scales("steps", given.trajectories, given.known, {});
  EXPECT_EQ(training.model.name, "steps");
  EXPECT_EQ(training.model.num_scales(), 2);
  EXPECT_EQ(training.training.accuracy(), 1.0);
  EXPECT_EQ(training.testing.accuracy(), 1.0);
  EXPECT_EQ(training.testing.boundary_distance, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(training.testing.boundary_ratio, (std::vector<double>{1.0, 1.0}));
}

TEST(TrainScales, TrainsOnAThirdAndTestsOnTheOthers) {
  const Examples given = examples(30, 0.1, 2);
  const ScaleTraining training = train_scales("steps", given.trajectories, given.known, {});
  EXPECT_EQ(std::accumulate(training.trained_on.begin(), training.trained_on.end(), 0), 10);
  EXPECT_EQ(training.training.trajectories, 10);
  EXPECT_EQ(training.testing.trajectories, 20);
  int64_t training_size = 0, testing_size = 0;
  for (size_t t = 0; t < given.trajectories.size(); ++t) {
    (training.trained_on[t] ? training_size : testing_size) +=
        static_cast<int64_t>(given.trajectories[t].size());
  }
  EXPECT_EQ(training.training.configurations(), training_size);
  EXPECT_EQ(training.testing.configurations(), testing_size);
}

TEST(TrainScales, DrawsAnotherThirdForAnotherSeedAndTheSameForTheSame) {
  const Examples given = examples(30, 0.1, 3);
  ScaleTrainingOptions options;
  const ScaleTraining a = train_scales("steps", given.trajectories, given.known, options);
  const ScaleTraining b = train_scales("steps", given.trajectories, given.known, options);
  options.seed = 2;
  const ScaleTraining c = train_scales("steps", given.trajectories, given.known, options);
  EXPECT_EQ(a.trained_on, b.trained_on);
  EXPECT_EQ(a.model, b.model);
  EXPECT_NE(a.trained_on, c.trained_on);
}

TEST(ScoreLabelling, CountsEveryConfigurationUnderItsKnownAndItsFoundLabel) {
  const Examples given = examples(9, 0.0, 4);
  const ScaleModel model = train_scales("steps", given.trajectories, given.known, {}).model;
  // The same trajectories, said to begin their second scale three configurations earlier.
  std::vector<ScaleLabels> earlier = given.known;
  int64_t all = 0;
  for (ScaleLabels& labels : earlier) {
    labels.first[1] -= 3;
    all += labels.num_configurations;
  }
  const LabellingScore score = score_labelling(given.trajectories, earlier, model);
  EXPECT_EQ(score.configurations(), all);
  EXPECT_EQ(score.confusion[2][1], 9 * 3);
  EXPECT_EQ(score.confusion[1][2], 0);
  EXPECT_DOUBLE_EQ(score.accuracy(), 1.0 - 27.0 / static_cast<double>(all));
  EXPECT_EQ(score.boundary_distance[1], 3.0);
}

}  // namespace
}  // namespace gable
