#include "nearest_planes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace gable {
namespace {

double squared_distance_to_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                   const Eigen::Vector3d& b) {
  const double t = (p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300);
  return (p - a - std::clamp(t, 0.0, 1.0) * (b - a)).squaredNorm();
}

double squared_distance(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners,
                        const Eigen::Vector3d& normal) {
  bool inside = true;
  double nearest_edge = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d &a = corners[i], &b = corners[(i + 1) % 3];
    if (normal.cross(b - a).dot(p - a) >= 0.0) continue;
    inside = false;
    nearest_edge = std::min(nearest_edge, squared_distance_to_segment(p, a, b));
  }
  const double height = normal.dot(p - corners[0]);
  return inside ? height * height : nearest_edge;
}

}  // namespace

std::vector<int> nearest_planes(const LabelledSurface& surface, int scale,
                                const std::vector<Eigen::Vector3d>& points) {
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  std::vector<int> planes(points.size(), -1);
  for (size_t i = 0; i < surface.triangles.size(); ++i) {
    std::array<Eigen::Vector3d, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = surface.vertices[surface.triangles[i][k]];
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.isZero()) continue;
    const Eigen::Vector3d unit = normal.normalized();
    for (size_t p = 0; p < points.size(); ++p) {
      const double height = unit.dot(points[p] - corners[0]);
      if (height * height >= nearest[p]) continue;
      const double distance = squared_distance(points[p], corners, unit);
      if (distance >= nearest[p]) continue;
      nearest[p] = distance;
      planes[p] = surface.planes[i][scale];
    }
  }
  return planes;
}

}  // namespace gable
