#pragma once

#include <gable/engine/scales/ordered_cloud.h>

#include <functional>
#include <span>
#include <vector>

namespace gable {

/// The k nearest neighbours of every point of a cloud, nearest first.
struct Neighbours {
  int k = 0;
  std::vector<int> indices;  ///< k per point

  std::span<const int> of(int point) const {
    return std::span(indices).subspan(static_cast<size_t>(point) * k, k);
  }
};

/// Searches the k nearest other points of every point in a kd-tree. Clouds of k points or fewer get
/// as many neighbours as there are other points.
Neighbours find_neighbours(const OrderedCloud& cloud, int k, int threads);

/// The k nearest points of `cloud` for every point of `queries` (same frame), a point at the same
/// place included.
Neighbours find_neighbours(const std::vector<Eigen::Vector3f>& cloud,
                           const std::vector<Eigen::Vector3f>& queries, int k, int threads);

/// The same, but each query's neighbours are handed to take(query, neighbours), on any thread and
/// in any order, and kept nowhere: at 4 k bytes a query they soon outweigh everything else.
void for_neighbours(const std::vector<Eigen::Vector3f>& cloud,
                    const std::vector<Eigen::Vector3f>& queries, int k, int threads,
                    const std::function<void(size_t, std::span<const int>)>& take);

}  // namespace gable
