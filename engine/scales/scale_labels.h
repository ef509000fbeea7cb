#pragma once

#include <vector>

namespace gable {

/// Which configurations of a trajectory belong to which structural scale. Scales are numbered from
/// 1 (finest) to K (coarsest); configurations before the first scale, fragments that no scale holds
/// (noise split into many shapes), have label 0. Labels never fall along a trajectory.
struct ScaleLabels {
  /// first[k - 1]: the first configuration of scale k, which represents it; never falling. A scale
  /// that is missing (no chimneys, so nothing finer than the roofs) has the first configuration of
  /// the scale after it, or, at the coarse end, num_configurations.
  std::vector<int> first;
  int num_configurations = 0;

  int num_scales() const { return static_cast<int>(first.size()); }
  /// The label of every configuration.
  std::vector<int> labels() const {
    std::vector<int> out(num_configurations, 0);
    for (int f : first) {
      for (int i = f; i < num_configurations; ++i) ++out[i];
    }
    return out;
  }
};

}  // namespace gable
