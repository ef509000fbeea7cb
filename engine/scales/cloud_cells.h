#pragma once

#include <gable/engine/scales/ordered_cloud.h>
#include <gable/residuals/point_moments.h>

#include <vector>

namespace gable {

/// The points of a cloud summed up in the cells of a cubic grid: many points as few moments.
struct CloudCells {
  std::vector<Eigen::Vector3f> centroids;  ///< of the points in each occupied cell
  std::vector<PointMoments> moments;       ///< relative to the origin of the cloud's positions

  int size() const { return static_cast<int>(centroids.size()); }
};

/// Sums up a cloud in the smallest cells (of 2^-i of the box's side) that hold at least
/// `points_per_cell` points on average.
CloudCells sum_up_in_cells(const OrderedCloud& cloud, double points_per_cell);

}  // namespace gable
