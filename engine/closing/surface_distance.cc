#include <gable/engine/closing/surface_distance.h>
#include <gable/grammar/solid/triangulate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

double squared_distance_to_edge(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * along).squaredNorm();
}

double squared_distance(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& t) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double square = normal.squaredNorm();
  if (square > 0.0) {
    bool above = true;
    for (int i = 0; i < 3; ++i) {
      above = above && (t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) >= 0.0;
    }
    if (above) return std::pow((p - t[0]).dot(normal), 2) / square;
  }
  return std::min({squared_distance_to_edge(p, t[0], t[1]), squared_distance_to_edge(p, t[1], t[2]),
                   squared_distance_to_edge(p, t[2], t[0])});
}

}  // namespace

SurfaceDistance::SurfaceDistance(const std::vector<Solid>& solids) {
  for (const Solid& solid : solids) {
    for (const Face& face : solid.faces) {
      for (const std::array<int, 3>& corners : triangulate(solid, face)) {
        Triangle triangle;
        for (int i = 0; i < 3; ++i) {
          triangle.corners[i] = solid.vertices[corners[i]];
          triangle.box.extend(triangle.corners[i]);
        }
        triangles_.push_back(triangle);
      }
    }
  }
}

double SurfaceDistance::operator()(const Eigen::Vector3d& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles_) {
    if (triangle.box.squaredExteriorDistance(p) >= least) continue;
    least = std::min(least, squared_distance(p, triangle.corners));
  }
  return std::sqrt(least);
}

}  // namespace gable
