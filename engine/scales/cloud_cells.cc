#include <gable/engine/scales/cloud_cells.h>

#include <algorithm>

namespace gable {
namespace {

constexpr int kFinestLevel = 20;

struct Box {
  Eigen::Vector3f low;
  float side = 1.0f;

  Eigen::Vector3i cell_of(const Eigen::Vector3f& p, int level) const {
    return ((p - low) * (static_cast<float>(1 << level) / side)).cast<int>();
  }
};

Box box_of(const OrderedCloud& cloud) {
  Eigen::Vector3f low = cloud.positions.front(), high = low;
  for (const Eigen::Vector3f& p : cloud.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low, std::max((high - low).maxCoeff(), 1e-30f)};
}

// Calls start(point) at each point that begins another cell. The order of the cloud runs through
// one cell of the grid after the other.
template <typename Start>
void for_cell_starts(const OrderedCloud& cloud, const Box& box, int level, const Start& start) {
  Eigen::Vector3i cell(-1, -1, -1);
  for (int p = 0; p < cloud.size(); ++p) {
    const Eigen::Vector3i next = box.cell_of(cloud.positions[p], level);
    if (next == cell) continue;
    cell = next;
    start(p);
  }
}

}  // namespace

CloudCells sum_up_in_cells(const OrderedCloud& cloud, double points_per_cell) {
  CloudCells cells;
  if (cloud.positions.empty()) return cells;
  const Box box = box_of(cloud);
  int level = kFinestLevel;
  for (; level > 0; --level) {
    int occupied = 0;
    for_cell_starts(cloud, box, level, [&](int) { ++occupied; });
    if (cloud.size() >= points_per_cell * occupied) break;
  }
  std::vector<int> starts;
  for_cell_starts(cloud, box, level, [&](int p) { starts.push_back(p); });
  starts.push_back(cloud.size());
  for (size_t c = 0; c + 1 < starts.size(); ++c) {
    PointMoments moments;
    for (int p = starts[c]; p < starts[c + 1]; ++p) moments.add(cloud.positions[p].cast<double>());
    cells.centroids.push_back(moments.centroid().cast<float>());
    cells.moments.push_back(moments);
  }
  return cells;
}

}  // namespace gable
