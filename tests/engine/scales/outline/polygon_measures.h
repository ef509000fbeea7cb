#pragma once

#include <gable/engine/scales/outline/outlined_region.h>
#include <gable/engine/scales/outline/plane_frame.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/engine/scales/planar_shape.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

inline const OrientedPlane kLevel(Eigen::Vector3d::UnitZ(), 0.0);

inline double total_area(const std::vector<SpacePolygon>& polygons) {
  double area = 0.0;
  for (const SpacePolygon& polygon : polygons) area += area_of(polygon);
  return area;
}

/// All rings of polygons in the frame of their plane.
inline std::vector<Ring> rings_of(const std::vector<SpacePolygon>& polygons,
                                  const PlaneFrame& frame) {
  std::vector<Ring> rings;
  const auto add = [&](const std::vector<Eigen::Vector3d>& ring) {
    Ring& flat = rings.emplace_back();
    for (const Eigen::Vector3d& p : ring) flat.push_back(frame.project(p));
  };
  for (const SpacePolygon& polygon : polygons) {
    add(polygon.outer);
    for (const auto& hole : polygon.holes) add(hole);
  }
  return rings;
}

/// Whether polygons on the plane z = 0 hold a point of it (even-odd rule).
inline bool covers(const std::vector<SpacePolygon>& polygons, double x, double y) {
  bool in = false;
  for (const Ring& ring : rings_of(polygons, PlaneFrame(kLevel, Eigen::Vector3d::Zero()))) {
    for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector2d &a = ring[i], &b = ring[j];
      if ((a.y() > y) != (b.y() > y) &&
          x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        in = !in;
      }
    }
  }
  return in;
}

}  // namespace gable
