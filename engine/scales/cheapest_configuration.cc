#include <gable/engine/scales/cheapest_configuration.h>
#include <gable/engine/scales/shape_plane.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

// Squared distances count as at most so many squared deviations.
constexpr double kMostSquares = 9.0;

// Parameters of a plane.
constexpr double kPlaneParameters = 3.0;

}  // namespace

int cheapest_configuration(const std::vector<Eigen::Vector3d>& points,
                           const CollapsedScan& collapsed, double deviation) {
  CHECK_GT(deviation, 0.0);
  CHECK_EQ(points.size(), collapsed.first_shapes.shape_of.size());
  const Trajectory& trajectory = collapsed.trajectory;
  // By the number of a shape, those that merges make included. The first shapes' own moments are in
  // another frame.
  PointMoments none;
  if (!points.empty()) none.reference = points.front();
  std::vector<PointMoments> moments(trajectory.num_first, none);
  std::vector<std::vector<int>> members(trajectory.num_first);
  for (size_t i = 0; i < points.size(); ++i) {
    const int shape = collapsed.first_shapes.shape_of[i];
    if (shape < 0) continue;
    moments[shape].add(points[i]);
    members[shape].push_back(static_cast<int>(i));
  }
  const auto squares_of = [&](size_t shape) {
    const ShapePlane plane = shape_plane(moments[shape]);
    double sum = 0.0;
    for (int i : members[shape]) {
      const double d = plane.normal.dot(points[i] - plane.centroid) / deviation;
      sum += std::min(d * d, kMostSquares);
    }
    return sum;
  };
  std::vector<double> squares;
  for (int shape = 0; shape < trajectory.num_first; ++shape) squares.push_back(squares_of(shape));

  // Relative to configuration 0.
  const double price =
      kPlaneParameters * std::log(std::max(3.0, static_cast<double>(points.size())));
  double length = 0.0, least = 0.0;
  int best = 0;
  for (size_t i = 0; i < trajectory.merges.size(); ++i) {
    const Merge& merge = trajectory.merges[i];
    PointMoments united = moments[merge.a];
    united += moments[merge.b];
    std::vector<int> both = std::move(members[merge.a]);
    both.insert(both.end(), members[merge.b].begin(), members[merge.b].end());
    moments.push_back(united);
    members.push_back(std::move(both));
    squares.push_back(squares_of(moments.size() - 1));
    length += squares.back() - squares[merge.a] - squares[merge.b] - price;
    if (length <= least) {
      least = length;
      best = static_cast<int>(i) + 1;
    }
  }
  return best;
}

}  // namespace gable
