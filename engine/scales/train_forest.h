#pragma once

#include <gable/engine/scales/forest.h>
#include <gable/engine/scales/scale_labels.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

/// A trajectory whose scales are known.
struct LabelledTrajectory {
  std::vector<ScaleFeatures> features;  ///< per configuration
  std::vector<int> labels;              ///< per configuration, see ScaleLabels
};

/// How a forest is trained. The number of trees and their depth are the paper's (CVPR 2018,
/// section 6, "Timings").
struct ForestTrainingOptions {
  int num_trees = 100;         ///< [1, 1000]
  int max_depth = 25;          ///< [1, 25]
  int min_samples = 8;         ///< nodes with fewer are not split, [2, 1e6]
  int features_per_split = 4;  ///< drawn anew at each node, [1, 18]
  /// Of the configurations of a trajectory with one label at most this many are used, evenly
  /// spread, the first and the last among them: neighbours look almost alike, and there are
  /// thousands of fine ones. [2, 1e9]
  int max_samples_per_label = 300;
  /// What a trajectory's configurations with one label weigh together: their number to the power
  /// of 1 - balance. 0: each weighs the same; 1: each label of each trajectory does. [0, 1]
  double balance = 0.5;
  /// Samples' worth of the labels' overall frequencies that is added to every leaf, so that no
  /// probability is 0 (Laplace smoothing). (0, 1000]
  double smoothing = 1.0;
  uint64_t seed = 1;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ForestTrainingOptions& options);

/// A forest that tells the labels 0 to `num_scales` apart. Trees are grown by OpenCV's random trees
/// on bootstrap samples; a leaf's distribution is that of all samples that reach it, whether they
/// were drawn for its tree or not. At least one configuration is needed, and labels must lie in
/// [0, num_scales]; a label without samples keeps a small probability everywhere. The same input
/// and seed give the same forest, on any number of threads.
Forest train_forest(const std::vector<LabelledTrajectory>& trajectories, int num_scales,
                    const ForestTrainingOptions& options);

}  // namespace gable
