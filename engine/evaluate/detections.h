#pragma once

#include <gable/engine/io/models/building.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// How many of one kind of detail were found (NPR Table 1).
struct DetectionScore {
  int truth = 0;    ///< in the truth
  int found = 0;    ///< in the model
  int correct = 0;  ///< pairs within the radius, one to one

  double precision() const { return found > 0 ? static_cast<double>(correct) / found : 1.0; }
  double recall() const { return truth > 0 ? static_cast<double>(correct) / truth : 1.0; }
};

/// Plan centres of all dormers, or of all chimneys, of the houses among the buildings; world.
std::vector<Eigen::Vector2d> dormer_centers(const std::vector<Building>& buildings);
std::vector<Eigen::Vector2d> chimney_centers(const std::vector<Building>& buildings);

/// A detection is correct when a truth centre that no nearer pair has taken lies within `radius`
/// metres (the paper: 3 pixels). Pairs are taken nearest first.
/// What is left near one of `faint`, true ones that need not be found, is not counted as found.
DetectionScore score_detections(const std::vector<Eigen::Vector2d>& found,
                                const std::vector<Eigen::Vector2d>& truth, double radius,
                                const std::vector<Eigen::Vector2d>& faint = {});

}  // namespace gable
