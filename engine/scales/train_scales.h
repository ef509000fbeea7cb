#pragma once

#include <gable/engine/scales/scale_model.h>
#include <gable/engine/scales/train_forest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

/// How well labels found agree with known ones, over all configurations of some trajectories.
struct LabellingScore {
  int trajectories = 0;
  /// confusion[known][found]: configurations.
  std::vector<std::vector<int64_t>> confusion;
  /// Per scale, finest first: how far the found beginning lies from the known one, configurations,
  /// median over the trajectories.
  std::vector<double> boundary_distance;
  /// The same as the ratio of the numbers of shapes there, the larger over the smaller.
  std::vector<double> boundary_ratio;

  int64_t configurations() const;
  /// Share of the configurations with the right label (CVPR 2018, table 1); 0 where there are none.
  double accuracy() const;
};

/// How a model is trained and tested.
struct ScaleTrainingOptions {
  ForestTrainingOptions forest;
  double gamma = 0.5;                 ///< see ScaleChainOptions
  double training_share = 1.0 / 3.0;  ///< of the trajectories, the rest tests; (0, 1]
  uint64_t seed = 1;                  ///< of the split
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ScaleTrainingOptions& options);

/// A trained model, and how it labels the trajectories that it was trained on and the others.
struct ScaleTraining {
  ScaleModel model;
  LabellingScore training;
  LabellingScore testing;
  std::vector<char> trained_on;  ///< per trajectory
};

/// Labels trajectories with a model and compares with their known scales; `known` has the same
/// number of scales as the model.
LabellingScore score_labelling(const std::vector<std::vector<ScaleFeatures>>& trajectories,
                               const std::vector<ScaleLabels>& known, const ScaleModel& model);

/// Trains a model on a random third of the trajectories and tests it on the others (CVPR 2018,
/// section 6). All of `known` have the same number of scales; there is at least one trajectory.
ScaleTraining train_scales(const std::string& name,
                           const std::vector<std::vector<ScaleFeatures>>& trajectories,
                           const std::vector<ScaleLabels>& known,
                           const ScaleTrainingOptions& options);

}  // namespace gable
