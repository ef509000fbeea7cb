#pragma once

#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>

namespace gable {

/// The plane of a polygon and its size.
struct FacePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< outward, unit; zero without area
  double offset = 0.0;                               ///< normal . x on the plane, metres
  double area = 0.0;                                 ///< holes subtracted, square metres

  double distance(const Eigen::Vector3d& point) const { return normal.dot(point) - offset; }
};

/// Normal by Newell's sum over all rings, through the mean of the outer ring's corners.
FacePlane face_plane(const Solid& solid, const Face& face);

}  // namespace gable
