#include "cli/sample_house.h"

#include <gable/grammar/random.h>

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

namespace gable {
namespace {

/// A parallelogram with its plane at each scale.
struct Face {
  Eigen::Vector3d corner, u, v;
  std::array<int, 3> planes;
};

}  // namespace

Scan sample_house(uint64_t seed, int num_points) {
  Random random(seed);
  const double length = random.uniform(8, 14), width = random.uniform(6, 9);
  const double eave = random.uniform(3, 6), rise = random.uniform(2, 4);
  const Eigen::Vector3d x(length, 0, 0), y(0, width, 0), z(0, 0, eave), o(0, 0, 0);
  const Eigen::Vector3d south(0, width / 2, rise), north(0, -width / 2, rise);
  const Eigen::Vector3d cx(1.4, 0, 0), cy(0, 1.2, 0), cz(0, 0, 2.5);
  std::vector<Face> faces = {{o, x, z, {0, 0, 0}},     {o, y, z, {1, 1, 1}},
                             {o + x, y, z, {2, 2, 2}}, {o + y, x, z, {3, 3, 3}},
                             {z, x, south, {4, 4, 4}}, {z + y, x, north, {5, 5, 4}}};
  const int chimneys = random.integer(1, 3);
  for (int i = 0; i < chimneys; ++i) {
    const Eigen::Vector3d at((0.1 + 0.3 * i) * length, 0.6 * width, eave + 0.6 * rise);
    const int plane = 6 + 5 * i;
    faces.push_back({at, cx, cz, {plane, 5, 4}});
    faces.push_back({at, cy, cz, {plane + 1, 5, 4}});
    faces.push_back({at + cx, cy, cz, {plane + 2, 5, 4}});
    faces.push_back({at + cy, cx, cz, {plane + 3, 5, 4}});
    faces.push_back({at + cz, cx, cy, {plane + 4, 5, 4}});
  }
  double total = 0.0;
  std::vector<double> sums;
  for (const Face& face : faces) sums.push_back(total += face.u.cross(face.v).norm());
  Scan scan;
  for (int i = 0; i < num_points; ++i) {
    const double at = random.uniform(0.0, total);
    size_t face = 0;
    while (face + 1 < faces.size() && sums[face] <= at) ++face;
    const Face& f = faces[face];
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Eigen::Vector3d noise(random.normal(0.003), random.normal(0.003), random.normal(0.003));
    scan.points.push_back(f.corner + u * f.u + v * f.v + noise);
    for (int k = 0; k < 3; ++k) {
      scan.labels["scale_" + std::to_string(k + 1)].push_back(f.planes[k]);
    }
  }
  return scan;
}

}  // namespace gable
