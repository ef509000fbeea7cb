#include <gable/engine/scales/absorb_small_shapes.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <numeric>
#include <queue>
#include <tuple>

namespace gable {
namespace {

// The shapes as they are united; what was united answers for all of its parts.
class United {
 public:
  explicit United(const FirstShapes& first)
      : into_(first.moments.size()),
        moments_(first.moments),
        inliers_(first.moments.size(), 0),
        adjacent_(first.moments.size()) {
    std::iota(into_.begin(), into_.end(), 0);
    for (int shape : first.shape_of) {
      if (shape >= 0) ++inliers_[shape];
    }
    for (const auto& [a, b] : first.adjacent) {
      adjacent_[a].push_back(b);
      adjacent_[b].push_back(a);
    }
  }

  int find(int shape) {
    while (into_[shape] != shape) shape = into_[shape] = into_[into_[shape]];
    return shape;
  }
  int inliers(int shape) const { return inliers_[shape]; }

  /// The neighbour with which a shape is nearest to one plane; -1 if it has none.
  int best_neighbour(int shape) {
    std::vector<int> around;
    for (int other : adjacent_[shape]) {
      if (find(other) != shape) around.push_back(find(other));
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    adjacent_[shape] = around;
    int best = -1;
    double lowest = 0.0;
    for (int other : around) {
      PointMoments both = moments_[shape];
      both += moments_[other];
      const double rms = plane_rms(both);
      if (best >= 0 && rms >= lowest) continue;
      best = other;
      lowest = rms;
    }
    return best;
  }

  void unite(int shape, int with) {
    into_[shape] = with;
    moments_[with] += moments_[shape];
    inliers_[with] += inliers_[shape];
    adjacent_[with].insert(adjacent_[with].end(), adjacent_[shape].begin(), adjacent_[shape].end());
    adjacent_[shape] = {};
  }

  const PointMoments& moments(int shape) const { return moments_[shape]; }

 private:
  std::vector<int> into_;
  std::vector<PointMoments> moments_;
  std::vector<int> inliers_;
  std::vector<std::vector<int>> adjacent_;
};

}  // namespace

void absorb_small_shapes(int min_inliers, FirstShapes* first) {
  United united(*first);
  const int n = static_cast<int>(first->moments.size());
  using Entry = std::tuple<int, double, int>;  // inliers, area, shape
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> small;
  const auto put = [&](int shape) {
    if (united.inliers(shape) >= min_inliers) return;
    small.push({united.inliers(shape), united.moments(shape).weight, shape});
  };
  for (int shape = 0; shape < n; ++shape) put(shape);
  while (!small.empty()) {
    const auto [inliers, area, shape] = small.top();
    small.pop();
    if (united.find(shape) != shape || united.inliers(shape) != inliers) continue;
    const int with = united.best_neighbour(shape);
    if (with < 0) continue;
    united.unite(shape, with);
    put(with);
  }

  std::vector<int> number(n, -1);
  std::vector<PointMoments> moments;
  for (int shape = 0; shape < n; ++shape) {
    const int root = united.find(shape);
    if (number[root] >= 0) continue;
    number[root] = static_cast<int>(moments.size());
    moments.push_back(united.moments(root));
  }
  for (int& shape : first->shape_of) {
    if (shape >= 0) shape = number[united.find(shape)];
  }
  for (auto& [a, b] : first->adjacent) {
    const int sa = number[united.find(a)], sb = number[united.find(b)];
    a = std::min(sa, sb);
    b = std::max(sa, sb);
  }
  std::erase_if(first->adjacent, [](const auto& pair) { return pair.first == pair.second; });
  std::sort(first->adjacent.begin(), first->adjacent.end());
  first->adjacent.erase(std::unique(first->adjacent.begin(), first->adjacent.end()),
                        first->adjacent.end());
  first->moments = std::move(moments);
}

}  // namespace gable
