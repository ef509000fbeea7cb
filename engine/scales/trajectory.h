#pragma once

#include <gable/engine/scales/scale_features.h>
#include <gable/residuals/point_moments.h>

#include <utility>
#include <vector>

namespace gable {

/// Where a trajectory starts: planar shapes found with a small tolerance (CVPR 2018, section 4,
/// "Initialization").
struct FirstShapes {
  std::vector<int> shape_of;  ///< per element of the scan: its shape, or -1
  /// Per shape, all with the same reference. A point weighs 1, a facet its area in square metres.
  std::vector<PointMoments> moments;
  std::vector<std::pair<int, int>> adjacent;  ///< (a, b) with a < b, sorted, each once
  double diagonal = 0.0;                      ///< of the bounding box of the scan, metres
};

/// One step of a trajectory: shapes `a` < `b` become one. First shapes have the numbers 0 to n - 1;
/// the result of the i-th merge has the number n + i.
struct Merge {
  int a = 0;
  int b = 0;
  double weight = 0.0;  ///< RMS distance to the merged plane, metres (CVPR 2018, eq. 1)
  bool operator==(const Merge&) const = default;
};

/// A fine-to-coarse sequence of configurations of planar shapes: configuration 0 has the first
/// shapes, configuration i what is left of them after i merges.
struct Trajectory {
  int num_first = 0;
  std::vector<Merge> merges;
  std::vector<ScaleFeatures> features;  ///< per configuration

  int num_configurations() const { return static_cast<int>(merges.size()) + 1; }
  int num_shapes(int configuration) const { return num_first - configuration; }
};

/// The shapes of a configuration: for every first shape the number of the shape that it is part of,
/// from 0, in the order of their lowest first shapes.
std::vector<int> shapes_at(const Trajectory& trajectory, int configuration);

}  // namespace gable
