#pragma once

#include <gable/grammar/height_field.h>

#include <Eigen/Core>

namespace gable {

/// The gradient of a facet's height with respect to the values of its block. A facet's height is
/// linear in the point, and so is its gradient, which makes sums over the pixels of a facet sums
/// over moments of their positions (see SampleSums).
struct FacetGradient {
  Eigen::Vector2d anchor;  ///< house frame, metres
  /// d height / d Block::values at (x, y) is `values` * (1, x - anchor.x, y - anchor.y).
  Eigen::Matrix<double, kNumBlockValues, 3> values;
  Eigen::Vector2d slope;  ///< d height / d (x, y)

  Eigen::Matrix<double, kNumBlockValues, 1> at(double x, double y) const {
    return values.col(0) + values.col(1) * (x - anchor.x()) + values.col(2) * (y - anchor.y());
  }
};

/// By automatic differentiation of facet_height at three points. Not finite for a hip of no length.
FacetGradient facet_gradient(const Block<double>& block, Facet facet);

}  // namespace gable
