#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/solid/plan_graph.h>
#include <gable/grammar/solid/solid.h>

#include <optional>
#include <vector>

namespace gable {

/// Solids over the plan as `label` describes it, one per connected body, leaving out those of less
/// than `least_volume` cubic metres. Nothing where a solid would not be valid (see check_solid),
/// also after rounding its vertices to 0.1 mm.
std::optional<std::vector<Solid>> solids_over_plan(const std::vector<PlanSegment>& segments,
                                                   const LabelFunction& label,
                                                   const std::vector<Plane>& planes,
                                                   double least_volume);

/// What the blocks `own` show above the upper envelope of the blocks `below`, or above the height
/// `base` where none of those stands. House frame. See solids_over_plan.
std::optional<std::vector<Solid>> solids_above(const std::vector<Block<double>>& own,
                                               const std::vector<Block<double>>& below,
                                               double base);

}  // namespace gable
