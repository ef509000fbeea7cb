#pragma once

#include <gable/residuals/point_moments.h>

namespace gable {

/// The plane through a shape's elements that minimises the squared distances (CVPR 2018, section 4,
/// "Merging operator"), in the frame of the moments' reference.
struct ShapePlane {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, of arbitrary sign
  double rms = 0.0;                                   ///< of the elements' distances, metres
  double width = 0.0;  ///< the smaller standard deviation of the elements along the plane, metres
};

/// The best plane of the elements behind `moments`, by principal component analysis.
ShapePlane shape_plane(const PointMoments& moments);

/// Only the RMS distance of that plane: what a merge of two shapes costs (CVPR 2018, eq. 1), from
/// their united moments.
double plane_rms(const PointMoments& moments);

}  // namespace gable
