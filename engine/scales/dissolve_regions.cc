#include <gable/engine/scales/dissolve_regions.h>
#include <gable/engine/scales/region_adjacency.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

std::vector<std::vector<int>> lists_of(const std::vector<std::pair<int, int>>& pairs,
                                       size_t count) {
  std::vector<std::vector<int>> lists(count);
  for (const auto& [a, b] : pairs) {
    lists[a].push_back(b);
    lists[b].push_back(a);
  }
  return lists;
}

std::vector<std::vector<int>> members_of(const std::vector<int>& region_of, size_t count) {
  std::vector<std::vector<int>> members(count);
  for (size_t p = 0; p < region_of.size(); ++p) {
    if (region_of[p] >= 0) members[region_of[p]].push_back(static_cast<int>(p));
  }
  return members;
}

}  // namespace

void dissolve_regions(const OrderedCloud& cloud, const Neighbours& neighbours,
                      const DissolveOptions& options, std::vector<int>* region_of,
                      std::vector<PointMoments>* moments) {
  const size_t count = moments->size();
  std::vector<std::vector<int>> adjacent =
      lists_of(adjacent_regions(neighbours, *region_of, options.threads), count);
  const std::vector<std::vector<int>> members = members_of(*region_of, count);
  std::vector<ShapePlane> planes;
  for (const PointMoments& m : *moments) {
    planes.push_back(m.weight >= 3.0 ? shape_plane(m) : ShapePlane());
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return (*moments)[a].weight < (*moments)[b].weight; });

  std::vector<char> gone(count, 0);
  std::vector<int> choice, larger;
  for (int region : order) {
    larger.clear();
    for (int other : adjacent[region]) {
      if (!gone[other] && (*moments)[other].weight > (*moments)[region].weight) {
        larger.push_back(other);
      }
    }
    if (larger.empty()) continue;
    choice.clear();
    const double size = static_cast<double>(members[region].size());
    const double fewest = options.min_share * size;
    double squares = 0.0;
    size_t fitting = 0;
    for (int p : members[region]) {
      // Most regions are surfaces of their own: a few of their points show it.
      const double left = size - static_cast<double>(choice.size());
      if (static_cast<double>(fitting) + left < fewest) break;
      double best = options.reach;
      int to = -1;
      for (int other : larger) {
        const Eigen::Vector3d d = cloud.positions[p].cast<double>() - planes[other].centroid;
        const double distance = std::abs(planes[other].normal.dot(d));
        if (distance < best) {
          best = distance;
          to = other;
        }
      }
      choice.push_back(to);
      if (to >= 0) ++fitting, squares += best * best;
    }
    if (static_cast<double>(fitting) < fewest || fitting == 0) continue;
    if (squares >
        options.max_excess * options.deviation * options.deviation * static_cast<double>(fitting)) {
      continue;
    }
    gone[region] = 1;
    (*moments)[region] = PointMoments();
    for (size_t i = 0; i < choice.size(); ++i) {
      const int p = members[region][i];
      (*region_of)[p] = choice[i];
      if (choice[i] >= 0) (*moments)[choice[i]].add(cloud.positions[p].cast<double>());
    }
  }
}

}  // namespace gable
