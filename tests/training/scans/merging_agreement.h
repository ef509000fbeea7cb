#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <array>

namespace gable {

/// How near merging by RMS distance from a surface's finest planes comes to its coarser scales.
struct MergingAgreement {
  /// Best adjusted Rand index of any configuration with the planes of structure and hull, by area.
  std::array<double, 2> best;
  std::array<int, 2> num_shapes;  ///< of that configuration
};

/// @param contact  distance at which planes are adjacent, metres
MergingAgreement merging_agreement(const LabelledSurface& surface, double contact);

/// Diagonal of a surface's bounding box, metres.
double diagonal(const LabelledSurface& surface);

}  // namespace gable
