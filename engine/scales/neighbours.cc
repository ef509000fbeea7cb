#include <gable/engine/parallel_ranges.h>
#include <gable/engine/scales/neighbours.h>

#include <algorithm>
#include <nanoflann.hpp>

namespace gable {
namespace {

// What nanoflann asks of a set of points.
struct PointSet {
  const std::vector<Eigen::Vector3f>& points;

  size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(size_t i, size_t dimension) const {
    return points[i][static_cast<Eigen::Index>(dimension)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, PointSet, float>,
                                        PointSet, 3, int>;

// Calls take(query, neighbours nearest first) for every query.
template <typename Take>
void search(const std::vector<Eigen::Vector3f>& cloud, const std::vector<Eigen::Vector3f>& queries,
            int k, int threads, const Take& take) {
  const PointSet set{cloud};
  Tree tree(3, set, nanoflann::KDTreeSingleIndexAdaptorParams(12));
  for_ranges(queries.size(), threads, [&](size_t begin, size_t end) {
    std::vector<int> found(k);
    std::vector<float> distances(k);
    for (size_t i = begin; i < end; ++i) {
      tree.knnSearch(queries[i].data(), k, found.data(), distances.data());
      take(i, found);
    }
  });
}

}  // namespace

Neighbours find_neighbours(const OrderedCloud& cloud, int k, int threads) {
  Neighbours out;
  out.k = std::min(k, cloud.size() - 1);
  if (out.k <= 0) return {};
  out.indices.resize(static_cast<size_t>(cloud.size()) * out.k);
  search(cloud.positions, cloud.positions, out.k + 1, threads,
         [&](size_t i, const std::vector<int>& found) {
           int* to = out.indices.data() + i * out.k;
           int taken = 0;
           // The point itself is first, unless others lie at the same place.
           for (int j : found) {
             if (j != static_cast<int>(i) && taken < out.k) to[taken++] = j;
           }
         });
  return out;
}

Neighbours find_neighbours(const std::vector<Eigen::Vector3f>& cloud,
                           const std::vector<Eigen::Vector3f>& queries, int k, int threads) {
  Neighbours out;
  out.k = std::min(k, static_cast<int>(cloud.size()));
  if (out.k <= 0) return {};
  out.indices.resize(queries.size() * out.k);
  for_neighbours(cloud, queries, out.k, threads, [&](size_t i, std::span<const int> found) {
    std::copy(found.begin(), found.end(), out.indices.begin() + i * out.k);
  });
  return out;
}

void for_neighbours(const std::vector<Eigen::Vector3f>& cloud,
                    const std::vector<Eigen::Vector3f>& queries, int k, int threads,
                    const std::function<void(size_t, std::span<const int>)>& take) {
  search(cloud, queries, std::clamp(k, 0, static_cast<int>(cloud.size())), threads, take);
}

}  // namespace gable
