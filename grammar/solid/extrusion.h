#pragma once

#include <Eigen/Core>
#include <vector>

#include <gable/grammar/solid/solid.h>

namespace gable {

/// A plan polygon, local frame, metres: outer ring and holes, in any orientation, without a
/// repeated last point.
struct PlanPolygon {
  std::vector<Eigen::Vector2d> outer;
  std::vector<std::vector<Eigen::Vector2d>> holes;
};

/// The prism over a polygon between the heights `base` and `top` (base < top): the LoD 1.2 solid of
/// a building outside the grammar.
Solid extrude(const PlanPolygon& polygon, double base, double top);

}  // namespace gable
