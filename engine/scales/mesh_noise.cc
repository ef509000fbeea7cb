#include <gable/engine/scales/mesh_noise.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr size_t kFewest = 1000;
constexpr size_t kFewestAround = 5;
// The median of |x| of a normal distribution of deviation 1.
constexpr double kMedianOfNormal = 0.6745;

std::vector<std::vector<int>> rings_of(const Scan& mesh) {
  std::vector<std::vector<int>> rings(mesh.points.size());
  for (size_t f = 0; f < mesh.facets.size(); ++f) {
    const auto corners = mesh.facets[f];
    for (size_t i = 0; i < corners.size(); ++i) {
      const int a = corners[i], b = corners[(i + 1) % corners.size()];
      if (a == b) continue;
      rings[a].push_back(b);
      rings[b].push_back(a);
    }
  }
  for (std::vector<int>& ring : rings) {
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  }
  return rings;
}

}  // namespace

double mesh_noise(const Scan& mesh) {
  const std::vector<std::vector<int>> rings = rings_of(mesh);
  std::vector<double> deviations;
  for (size_t v = 0; v < rings.size(); ++v) {
    if (rings[v].size() < kFewestAround) continue;
    PointMoments moments;
    moments.reference = mesh.points[v];
    for (int neighbour : rings[v]) moments.add(mesh.points[neighbour]);
    const ShapePlane plane = shape_plane(moments);
    const double distance = std::abs(plane.normal.dot(mesh.points[v] - plane.centroid));
    // The plane through n noisy neighbours is off by 1 / sqrt(n) of their noise itself.
    deviations.push_back(distance / std::sqrt(1.0 + 1.0 / static_cast<double>(rings[v].size())));
  }
  if (deviations.size() < kFewest) return 0.0;
  const auto middle = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 2);
  std::nth_element(deviations.begin(), middle, deviations.end());
  return *middle / kMedianOfNormal;
}

}  // namespace gable
