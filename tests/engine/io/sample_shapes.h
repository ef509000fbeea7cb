#pragma once

#include <gable/engine/scales/planar_shape.h>

namespace gable {

/// Two shapes in a national grid: a roof slope of 10 m x 8 m with a hole, and one without polygons.
inline ScaleShapes sample_shapes() {
  const Eigen::Vector3d origin(85062.75, 447412.5, 12.1);
  const Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d(0, 0.8, 0.6);
  const auto at = [&](double s, double t) -> Eigen::Vector3d { return origin + s * u + t * v; };
  PlanarShape roof;
  const Eigen::Vector3d normal = u.cross(v);
  roof.plane = OrientedPlane(normal, normal.dot(origin));
  roof.centroid = at(5, 4);
  roof.inliers = 1200;
  roof.area = 76.0;
  roof.rms = 0.1 / 3.0;
  roof.polygons.push_back(
      {{at(0, 0), at(10, 0), at(10, 8), at(0, 8)}, {{at(4, 3), at(4, 5), at(6, 5), at(6, 3)}}});
  roof.polygons.push_back({{at(12, 0), at(14, 0), at(13, 2), at(12.75, 0.5)}, {}});
  ScaleShapes shapes;
  shapes.configuration = 118;
  shapes.shape_of = {0, -1, 0, 1};
  shapes.shapes = {PlanarShape(), roof};
  shapes.coverage = 0.75;
  shapes.rms = 0.02;
  return shapes;
}

}  // namespace gable
