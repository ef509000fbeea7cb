#include <gable/engine/scales/shape_plane.h>
#include <gable/training/scans/plane_attachment.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace gable {
namespace {

struct Edge {
  int a, b;
  double weight;
};

}  // namespace

std::vector<Merge> merge_planes(std::span<const PointMoments> moments,
                                std::span<const std::pair<int, int>> adjacent,
                                std::span<const int> seed_of) {
  std::vector<PointMoments> all(moments.begin(), moments.end());
  std::vector<int> seeds(seed_of.begin(), seed_of.end());
  const auto weight = [&](int a, int b) {
    PointMoments both = all[a];
    return plane_rms(both += all[b]);
  };
  const auto may_merge = [&](int a, int b) {
    return seeds[a] < 0 || seeds[b] < 0 || seeds[a] == seeds[b];
  };
  std::vector<Edge> edges;
  for (const auto& [a, b] : adjacent) {
    if (may_merge(a, b)) edges.push_back({a, b, weight(a, b)});
  }
  std::vector<Merge> out;
  while (!edges.empty()) {
    const Edge best =
        *std::min_element(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
          return std::tie(x.weight, x.a, x.b) < std::tie(y.weight, y.a, y.b);
        });
    out.push_back({best.a, best.b, best.weight});
    const int merged = static_cast<int>(all.size());
    all.push_back(all[best.a]);
    all.back() += all[best.b];
    seeds.push_back(std::max(seeds[best.a], seeds[best.b]));
    std::vector<int> neighbours;
    std::erase_if(edges, [&](const Edge& edge) {
      const bool a_in = edge.a == best.a || edge.a == best.b;
      const bool b_in = edge.b == best.a || edge.b == best.b;
      if (a_in && !b_in) neighbours.push_back(edge.b);
      if (b_in && !a_in) neighbours.push_back(edge.a);
      return a_in || b_in;
    });
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (int other : neighbours) {
      if (may_merge(other, merged)) edges.push_back({other, merged, weight(other, merged)});
    }
  }
  return out;
}

std::vector<int> attach_planes(std::span<const PointMoments> moments,
                               std::span<const std::pair<int, int>> adjacent,
                               std::span<const int> seed_of) {
  const std::vector<Merge> merges = merge_planes(moments, adjacent, seed_of);
  std::vector<int> group(seed_of.begin(), seed_of.end());
  group.resize(seed_of.size() + merges.size(), -1);
  int next = 0;
  for (int seed : seed_of) next = std::max(next, seed + 1);
  // Up the tree to find what each union holds, then down again to tell its parts.
  for (size_t i = 0; i < merges.size(); ++i) {
    group[seed_of.size() + i] = std::max(group[merges[i].a], group[merges[i].b]);
  }
  for (size_t i = merges.size(); i-- > 0;) {
    int& whole = group[seed_of.size() + i];
    if (whole < 0) whole = next++;
    group[merges[i].a] = group[merges[i].b] = whole;
  }
  group.resize(seed_of.size());
  for (int& g : group) {
    if (g < 0) g = next++;
  }
  return group;
}

}  // namespace gable
