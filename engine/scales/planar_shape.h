#pragma once

#include <gable/residuals/oriented_plane.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A planar polygon in space: rings of points on the plane, each without a repeated last point.
struct SpacePolygon {
  std::vector<Eigen::Vector3d> outer;  ///< anticlockwise seen against the plane's normal
  std::vector<std::vector<Eigen::Vector3d>> holes;  ///< clockwise
};

/// A plane with the elements of a scan that lie on it, in the frame of the scan.
struct PlanarShape {
  OrientedPlane plane;  ///< normals of clouds without normals point up (or to +x, then +y)
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  int inliers = 0;                     ///< elements
  double area = 0.0;                   ///< of the polygons, square metres
  double rms = 0.0;                    ///< of the inliers' distances, metres
  std::vector<SpacePolygon> polygons;  ///< the outline of the inliers; empty where not asked for
};

/// The planar shapes of a scan at one structural scale.
struct ScaleShapes {
  int configuration = 0;      ///< of the trajectory
  std::vector<int> shape_of;  ///< per element of the scan: its shape, or -1
  std::vector<PlanarShape> shapes;
  double coverage = 0.0;  ///< share of the elements (of a mesh: of its area) in shapes
  double rms = 0.0;       ///< over all inliers, metres
};

}  // namespace gable
