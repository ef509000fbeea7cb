#include "examples/cli/training_text.h"

#include <cstdio>
#include <vector>

namespace gable {
namespace {

template <typename... Args>
std::string format(const char* pattern, Args... args) {
  char buffer[160];
  std::snprintf(buffer, sizeof(buffer), pattern, args...);
  return buffer;
}

std::string accuracy_line(const char* name, const LabellingScore& score) {
  if (score.trajectories == 0) return format("%s: no trajectories left\n", name);
  return format("%s: %.2f %% of %lld configurations of %d trajectories\n", name,
                100.0 * score.accuracy(), static_cast<long long>(score.configurations()),
                score.trajectories);
}

std::string boundary_table(const LabellingScore& score) {
  std::string text = "scale  off by configurations  off by a factor of shapes  (medians)\n";
  for (size_t k = 0; k < score.boundary_distance.size(); ++k) {
    text += format("%5zu  %21.1f  %25.3f\n", k + 1, score.boundary_distance[k],
                   score.boundary_ratio[k]);
  }
  return text;
}

std::string confusion_table(const LabellingScore& score) {
  std::string text = "known \\ found";
  for (size_t label = 0; label < score.confusion.size(); ++label) text += format("  %9zu", label);
  text += "\n";
  for (size_t known = 0; known < score.confusion.size(); ++known) {
    text += format("%13zu", known);
    for (const int64_t count : score.confusion[known]) {
      text += format("  %9lld", static_cast<long long>(count));
    }
    text += "\n";
  }
  return text;
}

/// What the model is judged by: trajectories that it has not seen, where there are any.
const LabellingScore& judged(const ScaleTraining& training) {
  return training.testing.trajectories > 0 ? training.testing : training.training;
}

}  // namespace

std::string training_text(const ScaleTraining& training) {
  const char* of = training.testing.trajectories > 0 ? "testing" : "training";
  return accuracy_line("training", training.training) + accuracy_line("testing", training.testing) +
         boundary_table(judged(training)) +
         format("confusion of the %s configurations (0: before the first scale)\n", of) +
         confusion_table(judged(training));
}

std::string model_card(const ScaleTraining& training, const ScaleTrainingOptions& options) {
  const ForestTrainingOptions& forest = options.forest;
  return "# " + training.model.name + "\n\nA model of structural scales, to be given to `gable " +
         "shapes --model`.\n\n" +
         format("- Scales: %d\n- Trajectories: %d for training, %d for testing\n",
                training.model.num_scales(), training.training.trajectories,
                training.testing.trajectories) +
         format("- Seed: %llu; training share: %g; gamma: %g\n",
                static_cast<unsigned long long>(options.seed), options.training_share,
                options.gamma) +
         format("- Forest: %d trees, depth %d, at least %d samples to split, %d features a split\n",
                forest.num_trees, forest.max_depth, forest.min_samples, forest.features_per_split) +
         format("- Samples: at most %d a label and trajectory, balance %g, smoothing %g\n\n",
                forest.max_samples_per_label, forest.balance, forest.smoothing) +
         "```\n" + training_text(training) + "```\n";
}

}  // namespace gable
