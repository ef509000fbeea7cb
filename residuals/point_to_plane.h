#pragma once

#include <ceres/autodiff_cost_function.h>
#include <gable/residuals/oriented_plane.h>

namespace gable {

/// The signed distance of one measured point to a plane: r = weight * (normal . point - offset).
/// Point and plane share a frame. One residual, metres if weight is 1; in standard deviations if
/// weight is 1 / sigma. Parameter block: OrientedPlane::values.
class PointToPlane {
 public:
  PointToPlane(const Eigen::Vector3d& point, double weight) : point_(point), weight_(weight) {}

  template <typename T>
  bool operator()(const T* plane, T* residual) const {
    residual[0] =
        (plane[0] * point_.x() + plane[1] * point_.y() + plane[2] * point_.z() - plane[3]) *
        weight_;
    return true;
  }

  static ceres::CostFunction* create(const Eigen::Vector3d& point, double weight) {
    return new ceres::AutoDiffCostFunction<PointToPlane, 1, kPlaneSize>(
        new PointToPlane(point, weight));
  }

 private:
  Eigen::Vector3d point_;
  double weight_;
};

}  // namespace gable
