#include <gable/engine/scales/cloud_cells.h>

#include <algorithm>

namespace gable {
namespace {

constexpr int kFinestLevel = 20;
// Summing up fewer points than this on average, time after time, costs little.
constexpr size_t kFewPoints = 3;

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

CloudCells::CloudCells(const OrderedCloud& cloud, double points_per_cell) : cloud_(cloud) {
  if (cloud.positions.empty()) return;
  const Box box = box_of(cloud);
  int level = kFinestLevel;
  size_t occupied = 0;
  for (; level >= 0; --level) {
    occupied = 0;
    for_cell_starts(cloud, box, level, [&](int) { ++occupied; });
    if (level == 0 || cloud.size() >= points_per_cell * static_cast<double>(occupied)) break;
  }
  begins_.reserve(occupied + 1);
  for_cell_starts(cloud, box, level, [&](int p) { begins_.push_back(p); });
  begins_.push_back(cloud.size());
  const bool keep = cloud.positions.size() >= kFewPoints * occupied;
  centroids_.reserve(occupied);
  if (keep) moments_.reserve(occupied);
  for (size_t c = 0; c < occupied; ++c) {
    const PointMoments moments = summed(static_cast<int>(c));
    centroids_.push_back(moments.centroid().cast<float>());
    if (keep) moments_.push_back(moments);
  }
}

PointMoments CloudCells::summed(int cell) const {
  PointMoments moments;
  const size_t c = static_cast<size_t>(cell);
  for (int p = begins_[c]; p < begins_[c + 1]; ++p) {
    moments.add(cloud_.positions[p].cast<double>());
  }
  return moments;
}

}  // namespace gable
