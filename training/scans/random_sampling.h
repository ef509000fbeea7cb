#pragma once

#include <gable/grammar/random.h>
#include <gable/training/scans/sample_surface.h>

namespace gable {

inline constexpr int kLeastTrainingPoints = 30000;
inline constexpr int kMostTrainingPoints = 143000;

/// How a training scan is sampled, drawn at random, so that a model learns from clean and bad scans
/// alike: noise of 0, 0.2, 0.5 or 1 % of the diagonal, outliers 0, 2 or 5 % of the points, each
/// alike likely; points between 30,000 and 143,000, the logarithm of their number uniform.
SampleOptions random_sampling(Random* random);

}  // namespace gable
