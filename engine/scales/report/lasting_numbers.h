#pragma once

#include <gable/engine/scales/trajectory.h>

#include <vector>

namespace gable {

/// Numbers for the shapes of a trajectory that last, for colours that do: where a shape comes from
/// two, it has the number of the one with more elements (of a mesh: more area). The m shapes of a
/// configuration have the numbers 0 to m - 1.
class LastingNumbers {
 public:
  LastingNumbers(const Trajectory& trajectory, const FirstShapes& first_shapes);

  /// Per first shape: the number of the shape that it is part of in a configuration.
  std::vector<int> at(int configuration) const;

 private:
  int num_first_;
  std::vector<int> parent_;  ///< of first shapes, then of the results of merges; -1: none
  std::vector<int> number_;
};

}  // namespace gable
