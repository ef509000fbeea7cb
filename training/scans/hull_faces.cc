#include <gable/training/scans/hull_faces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kWallReach = 0.5;              // metres
constexpr double kWallCosine = 0.939692620786;  // 20 degrees

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * (b - a)).norm();
}

/// From a point to a face seen from above: 0 inside, otherwise to its nearest edge, metres.
double plan_distance(const Solid& solid, const Face& face, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const std::vector<int>& ring : face.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d a = solid.vertices[ring[i]].head<2>();
      const Eigen::Vector2d b = solid.vertices[ring[(i + 1) % ring.size()]].head<2>();
      nearest = std::min(nearest, distance_to_segment(p, a, b));
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
  }
  return inside ? 0.0 : nearest;
}

}  // namespace

HullFaces::HullFaces(const Solid& hull) : hull_(hull) {
  for (const Face& face : hull.faces) planes_.push_back(face_plane(hull, face));
}

int HullFaces::face_for(SurfaceType type, const Eigen::Vector3d& centre,
                        const Eigen::Vector3d& normal) const {
  const bool is_wall = type == SurfaceType::kWall;
  int best = -1;
  double best_distance = is_wall ? kWallReach : std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < hull_.faces.size(); ++i) {
    if (hull_.faces[i].type != type) continue;
    if (is_wall && planes_[i].normal.dot(normal) < kWallCosine) continue;
    const double distance = plan_distance(hull_, hull_.faces[i], centre.head<2>());
    if (distance < best_distance) best = static_cast<int>(i), best_distance = distance;
  }
  if (best < 0 && is_wall) return face_for(SurfaceType::kRoof, centre, normal);
  return best;
}

}  // namespace gable
