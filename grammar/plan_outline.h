#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/solid/extrusion.h>

#include <vector>

namespace gable {

/// The outline of a house in plan: the union of its components and garages, local frame (world less
/// House::origin, turned by the azimuth), metres. One polygon per connected piece; outer rings
/// anticlockwise, holes clockwise, no collinear vertices. Edges closer than a micrometre count as
/// one, so that blocks which touch have no gap between them.
std::vector<PlanPolygon> plan_outline(const House& house);

}  // namespace gable
