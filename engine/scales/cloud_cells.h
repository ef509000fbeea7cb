#pragma once

#include <gable/engine/scales/ordered_cloud.h>
#include <gable/residuals/point_moments.h>

#include <vector>

namespace gable {

/// The points of a cloud summed up in the cells of a cubic grid: many points as few moments. Points
/// of a cell follow each other in the cloud, so cells of few points are kept as where they begin,
/// which takes less memory than their moments. A cell with points within rounding of its sides or
/// at the end of the box may be in several parts.
class CloudCells {
 public:
  /// Sums up a cloud in the smallest cells (of 2^-i of the box's side) that hold at least
  /// `points_per_cell` points on average. The cloud must outlive the cells.
  CloudCells(const OrderedCloud& cloud, double points_per_cell);

  int size() const { return static_cast<int>(centroids_.size()); }
  /// Of the points in each occupied cell.
  const std::vector<Eigen::Vector3f>& centroids() const { return centroids_; }
  /// Of the points of a cell, relative to the origin of the cloud's positions.
  PointMoments moments(int cell) const {
    return moments_.empty() ? summed(cell) : moments_[static_cast<size_t>(cell)];
  }

 private:
  PointMoments summed(int cell) const;

  const OrderedCloud& cloud_;
  std::vector<int> begins_;  ///< the first point of each cell, then the number of points
  std::vector<Eigen::Vector3f> centroids_;
  std::vector<PointMoments> moments_;  ///< none where cells have few points
};

}  // namespace gable
