#pragma once

#include <gable/grammar/ring.h>
#include <gable/grammar/solid/extrusion.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// Distance between two rings counted as areas, 0 where they overlap, metres.
double ring_distance(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b);

/// The largest piece of the union of convex rings that run anticlockwise: an anticlockwise outer
/// ring and clockwise holes. Each ring is grown by 1-4 mm and turned by less than a thousandth of a
/// degree first, all by different amounts, so that no two edges lie in one line; the result is
/// exact for those.
PlanPolygon union_of_convex(const std::vector<std::vector<Eigen::Vector2d>>& rings);

}  // namespace gable
