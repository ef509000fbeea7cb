#include <gable/engine/scales/cloud_cells.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

using Cell = std::array<int, 3>;

// A grid with 2^level cells along the longest side of the cloud's box.
struct Grid {
  Eigen::Vector3f low;
  float cells_per_metre = 1.0f;

  Grid(const OrderedCloud& cloud, int level) : low(cloud.positions[0]) {
    Eigen::Vector3f high = low;
    for (const Eigen::Vector3f& p : cloud.positions) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    cells_per_metre = static_cast<float>(1 << level) / (high - low).maxCoeff();
  }
  Cell cell_of(const Eigen::Vector3f& p) const {
    const Eigen::Vector3i at = ((p - low) * cells_per_metre).cast<int>();
    return {at.x(), at.y(), at.z()};
  }
};

std::map<Cell, PointMoments> slow_cells(const OrderedCloud& cloud, int level) {
  const Grid grid(cloud, level);
  std::map<Cell, PointMoments> cells;
  for (const Eigen::Vector3f& p : cloud.positions) cells[grid.cell_of(p)].add(p.cast<double>());
  return cells;
}

TEST(CloudCells, HoldEveryPointOnce) {
  const OrderedCloud cloud = order_cloud(box_cloud(3000, 0.05, 1).points);
  for (const double points_per_cell : {0.5, 1.0, 2.0, 4.0, 30.0, 1e9}) {
    const CloudCells cells(cloud, points_per_cell);
    PointMoments all, expected;
    for (int c = 0; c < cells.size(); ++c) all += cells.moments(c);
    for (const Eigen::Vector3f& p : cloud.positions) expected.add(p.cast<double>());
    EXPECT_EQ(all.weight, cloud.size());
    EXPECT_LT((all.sum - expected.sum).norm(), 1e-8);
    EXPECT_LT((all.squares - expected.squares).norm(), 1e-7);
  }
}

TEST(CloudCells, AreTheSmallestWithEnoughPoints) {
  const OrderedCloud cloud = order_cloud(box_cloud(3000, 0.05, 2).points);
  // On either side of where moments are kept rather than summed up on demand.
  for (const double points_per_cell : {1.5, 10.0, 100.0}) {
    int level = 20;
    while (cloud.size() < points_per_cell * slow_cells(cloud, level).size()) --level;
    ASSERT_GT(level, 0);
    const std::map<Cell, PointMoments> slow = slow_cells(cloud, level);
    const CloudCells cells(cloud, points_per_cell);
    EXPECT_LE(cells.size(), static_cast<int>(slow.size()) + 3);  // few are in two parts
    const Grid grid(cloud, level);
    std::map<Cell, PointMoments> fast;
    for (int c = 0; c < cells.size(); ++c) {
      const PointMoments moments = cells.moments(c);
      EXPECT_LT((cells.centroids()[c].cast<double>() - moments.centroid()).norm(), 1e-5);
      fast[grid.cell_of(cells.centroids()[c])] += moments;
    }
    ASSERT_EQ(fast.size(), slow.size());
    for (const auto& [cell, moments] : slow) {
      ASSERT_EQ(fast.count(cell), 1u);
      EXPECT_EQ(fast[cell].weight, moments.weight);
      EXPECT_LT((fast[cell].sum - moments.sum).norm(), 1e-8);
      EXPECT_LT((fast[cell].squares - moments.squares).norm(), 1e-7);
    }
  }
}

TEST(CloudCells, AreNoneInAnEmptyCloud) {
  const OrderedCloud none;
  EXPECT_EQ(CloudCells(none, 2.0).size(), 0);
}

}  // namespace
}  // namespace gable
