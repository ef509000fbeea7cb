#pragma once

#include <gable/residuals/oriented_plane.h>
#include <gable/residuals/point_moments.h>

namespace gable {

/// How well the points of a plane determine it, to first order.
struct PlaneUncertainty {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();  ///< covariance of the normal, square radians
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double noise = 0.0;     ///< standard deviation of a point's distance, metres
  double distance = 0.0;  ///< variance of the plane's distance at the centroid, square metres

  /// The larger standard deviation of the normal's two angles, radians.
  double angle_deviation() const;
  /// Variance of the plane's distance at a point, square metres.
  double variance_at(const Eigen::Vector3d& point) const {
    return distance + (point - centroid).dot(normal * (point - centroid));
  }
};

/// From the moments of the plane's points, in its frame; a weight of 1 is one independent
/// measurement. The noise is that of the points about the plane, W - 3 degrees of freedom left.
///
/// With the scatter l0 across the plane, l1 and l2 along its principal directions, and the noise's
/// variance s^2, the normal turns towards direction i with a variance of s^2 l_i / (l_i - l0)^2
/// (the perturbation of an eigenvector; s^2 / l_i where the plane is thin), at most 1: a direction
/// that the points leave open. Both directions are uncorrelated.
PlaneUncertainty plane_uncertainty(const OrientedPlane& plane, const PointMoments& moments);

}  // namespace gable
