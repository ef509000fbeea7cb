#pragma once

#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A plan polygon, local frame, metres: outer ring and holes, in any orientation, without a
/// repeated last point.
struct PlanPolygon {
  std::vector<Eigen::Vector2d> outer;
  std::vector<std::vector<Eigen::Vector2d>> holes;
};

/// Whether a point lies inside a polygon and outside its holes: even-odd over all rings.
bool polygon_holds(const PlanPolygon& polygon, const Eigen::Vector2d& point);

/// The prism over a polygon between the heights `base` and `top` (base < top): the LoD 1.2 solid of
/// a building outside the grammar. Rings may repeat points, touch or cross themselves and each
/// other: the inside is counted even-odd, vertices are moved by up to 5 cm where the prism would
/// not be valid otherwise, and of several bodies the largest is returned. A solid without faces is
/// returned where nothing is left: fewer than three distinct points, no area, base >= top, or
/// coordinates that are not finite.
Solid extrude(const PlanPolygon& polygon, double base, double top);

}  // namespace gable
