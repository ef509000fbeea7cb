#pragma once

#include <gable/grammar/solid/plan_graph.h>

namespace gable {

/// Walks round the edges of `graph` and fills in its cells and the edges' references to them.
/// Returns false where the labels along one boundary differ or a hole has no cell round it.
bool trace_cells(PlanGraph* graph);

}  // namespace gable
