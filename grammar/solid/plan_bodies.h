#pragma once

#include <gable/grammar/solid/plan_graph.h>
#include <gable/grammar/solid/surface_mesh.h>

#include <optional>
#include <vector>

namespace gable {

/// The boundaries of the solids that a divided plan describes, one per connected body. Cells belong
/// to one body where they share a piece of vertical section of positive area; bodies that touch
/// in an edge or a point stay apart. Lower faces are ground, upper faces roof, the rest walls.
/// Bodies are ordered by their first cell.
std::vector<SurfaceMesh> raise_bodies(const PlanGraph& graph, const std::vector<Plane>& planes);

}  // namespace gable
