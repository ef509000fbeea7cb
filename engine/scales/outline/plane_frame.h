#pragma once

#include <gable/residuals/oriented_plane.h>

#include <Eigen/Core>

namespace gable {

/// Right-handed coordinates on a plane, in metres: seen against the normal, `y_axis` lies to the
/// left of `x_axis`. `x_axis` is level, and +x on level planes.
struct PlaneFrame {
  Eigen::Vector3d origin;  ///< on the plane
  Eigen::Vector3d x_axis;
  Eigen::Vector3d y_axis;

  /// With its origin at the foot of `near`.
  PlaneFrame(const OrientedPlane& plane, const Eigen::Vector3d& near)
      : origin(near - plane.signed_distance(near) * plane.normal()) {
    const Eigen::Vector3d normal = plane.normal();
    const Eigen::Vector3d level = Eigen::Vector3d::UnitZ().cross(normal);
    x_axis = level.norm() > 1e-6
                 ? level.normalized()
                 : Eigen::Vector3d(Eigen::Vector3d::UnitX() - normal.x() * normal).normalized();
    y_axis = normal.cross(x_axis);
  }

  Eigen::Vector2d project(const Eigen::Vector3d& p) const {
    return {x_axis.dot(p - origin), y_axis.dot(p - origin)};
  }
  Eigen::Vector3d lift(const Eigen::Vector2d& q) const {
    return origin + q.x() * x_axis + q.y() * y_axis;
  }
};

}  // namespace gable
