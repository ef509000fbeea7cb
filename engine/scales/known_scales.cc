#include <gable/engine/scales/known_scales.h>
#include <glog/logging.h>

#include <algorithm>
#include <map>

namespace gable {
namespace {

// The elements of a shape that count: how many, and in which planes.
struct Overlap {
  double size = 0.0;
  std::map<int, double> in_plane;
};

// Intersection over union of a shape with the plane that it matches, 0 if it matches none. A shape
// has at most one plane of which it shares more than half of the union.
double matched(const Overlap& shape, const std::vector<double>& plane_sizes) {
  for (const auto& [plane, common] : shape.in_plane) {
    const double share = common / (shape.size + plane_sizes[plane] - common);
    if (share > 0.5) return share;
  }
  return 0.0;
}

}  // namespace

std::vector<double> agreement_with(const std::vector<int>& truth, const FirstShapes& first,
                                   const Trajectory& trajectory) {
  CHECK_EQ(truth.size(), first.shape_of.size());
  const int num_planes = truth.empty() ? 0 : *std::max_element(truth.begin(), truth.end()) + 1;
  std::vector<double> plane_sizes(num_planes, 0.0);
  std::vector<Overlap> shapes(first.moments.size());
  for (size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] < 0) continue;
    plane_sizes[truth[i]] += 1.0;
    if (first.shape_of[i] < 0) continue;
    shapes[first.shape_of[i]].size += 1.0;
    shapes[first.shape_of[i]].in_plane[truth[i]] += 1.0;
  }
  const double planes = static_cast<double>(
      std::count_if(plane_sizes.begin(), plane_sizes.end(), [](double s) { return s > 0.0; }));

  double sum = 0.0;
  for (const Overlap& shape : shapes) sum += matched(shape, plane_sizes);
  std::vector<double> agreement;
  const auto add_quality = [&] {
    const double count = 0.5 * (planes + trajectory.num_shapes(static_cast<int>(agreement.size())));
    agreement.push_back(count > 0.0 ? sum / count : 0.0);
  };
  add_quality();
  for (const Merge& merge : trajectory.merges) {
    Overlap made = std::move(shapes[merge.a]);
    const Overlap other = std::move(shapes[merge.b]);
    sum -= matched(made, plane_sizes) + matched(other, plane_sizes);
    made.size += other.size;
    for (const auto& [plane, common] : other.in_plane) made.in_plane[plane] += common;
    sum += matched(made, plane_sizes);
    shapes.push_back(std::move(made));
    add_quality();
  }
  return agreement;
}

ScaleLabels known_scales(const std::vector<std::vector<int>>& truths, const FirstShapes& first,
                         const Trajectory& trajectory) {
  const int n = trajectory.num_configurations();
  ScaleLabels labels;
  labels.num_configurations = n;
  // best[i]: the highest sum of agreements so far with the last scale at or before i.
  std::vector<double> best(n, 0.0);
  std::vector<std::vector<int>> places;
  for (size_t k = 1; k < truths.size(); ++k) {
    const std::vector<double> agreement = agreement_with(truths[k], first, trajectory);
    std::vector<int> place(n);
    for (int i = 0; i < n; ++i) {
      const double here = best[i] + agreement[i];
      const bool better = i == 0 || here > best[i - 1];
      best[i] = better ? here : best[i - 1];
      place[i] = better ? i : place[i - 1];
    }
    places.push_back(place);
  }
  int end = n - 1;
  labels.first.resize(truths.size(), 0);
  for (size_t k = truths.size(); k-- > 1;) {
    end = places[k - 1][end];
    labels.first[k] = end;
  }
  return labels;
}

}  // namespace gable
