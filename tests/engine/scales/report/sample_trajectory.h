#pragma once

#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>
#include <gable/engine/scan.h>
#include <gable/grammar/random.h>

#include <cmath>
#include <utility>
#include <vector>

namespace gable {

/// A level strip of `num_first` squares in a row with four points each, the last one without shape,
/// merged in random order down to one.
struct SampleTrajectory {
  Scan scan;
  FirstShapes first_shapes;
  Trajectory trajectory;
  ScaleLabels labels;

  explicit SampleTrajectory(int num_first, uint64_t seed = 1) {
    for (int shape = 0; shape < num_first; ++shape) {
      for (const auto& [x, y] : std::vector<std::pair<double, double>>{
               {0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}}) {
        scan.points.emplace_back(shape + x, 10.0 * y, 0.0);
        first_shapes.shape_of.push_back(shape);
      }
    }
    scan.points.emplace_back(num_first + 1.0, 1.0, 0.0);
    first_shapes.shape_of.push_back(-1);
    first_shapes.moments.assign(num_first, PointMoments{});
    for (int i = 0; i < 4 * num_first; ++i) {
      first_shapes.moments[first_shapes.shape_of[i]].add(scan.points[i]);
    }
    first_shapes.diagonal = std::hypot(num_first + 0.75, 5.0);
    trajectory.num_first = num_first;
    Random random(seed);
    std::vector<int> whole;
    for (int shape = 0; shape < num_first; ++shape) whole.push_back(shape);
    while (whole.size() > 1) {
      const int at = random.integer(0, static_cast<int>(whole.size()) - 2);
      const int a = std::min(whole[at], whole[at + 1]), b = std::max(whole[at], whole[at + 1]);
      const int i = static_cast<int>(trajectory.merges.size());
      trajectory.merges.push_back({a, b, 1e-3 * std::pow(1.05, i)});
      whole[at] = num_first + i;
      whole.erase(whole.begin() + at + 1);
    }
    labels.num_configurations = trajectory.num_configurations();
    labels.first = {num_first / 2, num_first - num_first / 8, num_first - 3};
  }
};

}  // namespace gable
