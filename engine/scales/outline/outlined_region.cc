#include <gable/engine/scales/outline/outlined_region.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace gable {

std::vector<SpacePolygon> lifted(std::vector<OutlinedRegion> regions, const PlaneFrame& frame) {
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  const auto lift = [&frame](const Ring& ring) {
    std::vector<Eigen::Vector3d> out;
    for (const Eigen::Vector2d& q : ring) out.push_back(frame.lift(q));
    return out;
  };
  std::vector<SpacePolygon> polygons;
  for (const OutlinedRegion& region : regions) {
    SpacePolygon& polygon = polygons.emplace_back();
    polygon.outer = lift(region.outer);
    for (const Ring& hole : region.holes) polygon.holes.push_back(lift(hole));
  }
  return polygons;
}

double area_of(const SpacePolygon& polygon) {
  const auto ring_area = [](const std::vector<Eigen::Vector3d>& ring) {
    Eigen::Vector3d twice = Eigen::Vector3d::Zero();
    for (size_t i = 2; i < ring.size(); ++i) {
      twice += (ring[i - 1] - ring[0]).cross(ring[i] - ring[0]);
    }
    return twice.norm() / 2.0;
  };
  double area = ring_area(polygon.outer);
  for (const auto& hole : polygon.holes) area -= ring_area(hole);
  return area;
}

}  // namespace gable
