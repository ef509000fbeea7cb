#pragma once

#include <gable/engine/scales/planar_shape.h>

#include <span>
#include <string>
#include <vector>

namespace gable {

/// How closely points are outlined.
struct InlierPolygonOptions {
  /// Edge of the square that one point stands for, metres, [0, 1e6]; 0: measured, see
  /// `planar_spacing`.
  double spacing = 0.0;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const InlierPolygonOptions& options);

/// The outline of points projected onto a plane: their alpha hull (the alpha shape of CVPR 2018,
/// figure 2, with arcs for its edges) for an alpha of 2.5 spacings, so that evenly or randomly
/// sampled surfaces have no holes of their own, and half a spacing around it, which a point stands
/// for, so that areas have no bias. Exact to about half a spacing, or to 1/2000 of the points'
/// extent where that is more. Separate islands are separate polygons, largest first; islands that
/// have no width (fewer than three points, points on a line) are none. Rings are simple and lie on
/// the plane. Any frame, coordinates of any size. O(points) and O(area / spacing^2).
std::vector<SpacePolygon> inlier_polygons(std::span<const Eigen::Vector3d> points,
                                          const OrientedPlane& plane,
                                          const InlierPolygonOptions& options = {});

/// The edge of the square that one point stands for on a plane, metres: from the distances of up to
/// 200 of the points to their 8th neighbours, where the points are sparse (upper quartile). 0 where
/// there are less than 3 places.
double planar_spacing(std::span<const Eigen::Vector3d> points, const OrientedPlane& plane);

}  // namespace gable
