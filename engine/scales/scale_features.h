#pragma once

#include <array>

namespace gable {

/// What a configuration of planar shapes looks like: four histograms over all pairs of adjacent
/// shapes, each with a sum of 1 (or all 0 where there is no pair), one after the other (CVPR 2018,
/// section 5, "Feature vector").
inline constexpr int kDistanceBins = 5;   ///< distance of the centroids
inline constexpr int kAlignmentBins = 4;  ///< |n_i . n_j|
inline constexpr int kAreaBins = 5;       ///< 1 - |s_i - s_j| / (s_i + s_j)
inline constexpr int kVerticalBins = 4;   ///< ||n_i . z| - |n_j . z||
inline constexpr int kNumFeatures = kDistanceBins + kAlignmentBins + kAreaBins + kVerticalBins;

using ScaleFeatures = std::array<float, kNumFeatures>;

}  // namespace gable
