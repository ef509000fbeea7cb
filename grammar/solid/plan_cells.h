#pragma once

#include <gable/grammar/solid/plan_graph.h>

namespace gable {

/// Whether a point lies inside a simple ring of the plan (either orientation).
bool ring_contains(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p);

/// Twice the signed area of a ring of the plan: positive when anticlockwise.
double twice_area(const std::vector<Eigen::Vector2d>& ring);

/// Walks round the edges of `graph` and fills in its cells and the edges' references to them.
/// Returns false where the labels along one boundary differ or a hole has no cell round it.
bool trace_cells(PlanGraph* graph);

}  // namespace gable
