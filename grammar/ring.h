#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace gable {

/// A closed ring of a plane, without a repeated last point.
using Ring = std::vector<Eigen::Vector2d>;

/// Area of a ring (shoelace formula around its first point): positive where it runs anticlockwise.
double signed_area(const Ring& ring);

/// Even-odd rule for a point that lies on no edge.
bool ring_holds(const Ring& ring, const Eigen::Vector2d& point);

/// Even-odd rule over several rings for a point that lies on no edge of them.
bool rings_hold(std::span<const Ring> rings, const Eigen::Vector2d& point);

}  // namespace gable
