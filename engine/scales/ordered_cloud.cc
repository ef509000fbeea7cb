#include <gable/engine/scales/ordered_cloud.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace gable {
namespace {

// Spreads the lowest 21 bits so that two zeros follow each.
uint64_t spread(uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffffULL;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

}  // namespace

OrderedCloud order_cloud(const std::vector<Eigen::Vector3d>& points) {
  OrderedCloud cloud;
  if (points.empty()) return cloud;
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const Eigen::Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  cloud.centre = 0.5 * (low + high);
  cloud.diagonal = (high - low).norm();
  const double side = std::max((high - low).maxCoeff(), 1e-300);
  const double scale = ((1 << 21) - 1) / side;
  std::vector<std::pair<uint64_t, int>> keys(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d cell = (points[i] - low) * scale;
    keys[i] = {spread(static_cast<uint64_t>(cell.x())) |
                   spread(static_cast<uint64_t>(cell.y())) << 1 |
                   spread(static_cast<uint64_t>(cell.z())) << 2,
               static_cast<int>(i)};
  }
  std::sort(keys.begin(), keys.end());
  cloud.positions.reserve(points.size());
  cloud.source.reserve(points.size());
  for (const auto& [key, i] : keys) {
    cloud.positions.push_back((points[i] - cloud.centre).cast<float>());
    cloud.source.push_back(i);
  }
  return cloud;
}

}  // namespace gable
