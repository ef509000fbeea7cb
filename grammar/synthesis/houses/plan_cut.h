#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/solid/extrusion.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The part of a simple ring on the left of the line through `point` along `direction`. Pieces that
/// it falls into stay joined along the line.
std::vector<Eigen::Vector2d> left_of_line(const std::vector<Eigen::Vector2d>& ring,
                                          const Eigen::Vector2d& point,
                                          const Eigen::Vector2d& direction);

/// Whether a point lies inside a simple ring.
bool inside_ring(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& point);

/// Cuts one end of an outline obliquely: the end across `along` (a unit vector, towards the end) is
/// cut by a line that leaves one of its corners and runs at `angle` radians to it into the plan.
/// `left`: which corner. The outline without holes.
PlanPolygon cut_obliquely(const PlanPolygon& outline, const Eigen::Vector2d& along, double angle,
                          bool left);

/// The outline as a register has it: moved by a normal deviate of 0.3 `most` (each way, at most
/// `most` metres), turned about its middle by up to a degree.
PlanPolygon register_outline(const PlanPolygon& outline, double most, Random* random);

}  // namespace gable
