#pragma once

#include <Eigen/Core>

namespace gable {

/// A measured height.
struct HeightSample {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< local frame, metres
  double weight = 1.0;  ///< square metres of the plan that it speaks for, > 0
};

}  // namespace gable
