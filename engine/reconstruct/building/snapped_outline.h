#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/solid/extrusion.h>

namespace gable {

/// An outline whose corners are moved onto the walls of a house's blocks where they are within
/// `tolerance` metres of them along an axis of the house, so that it leaves no strips narrower than
/// that along them; corners on one straight line then become one edge. The outline as it is where
/// that would let edges meet or leave no area. outline: local frame of the house.
PlanPolygon snapped_to_blocks(const PlanPolygon& outline, const House& house, double tolerance);

}  // namespace gable
