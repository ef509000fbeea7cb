#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/known_outline.h>
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

/// A known outline that a house fills, house frame, and all blocks of the house that stand on the
/// ground, which share it out among them (outline_margins.h).
struct OutlineCover {
  KnownOutline outline;
  std::vector<Block<double>> ground_blocks;
};

/// A block of a part, and whether it stands on the ground or on a roof.
struct PartBlock {
  Block<double> block;
  bool on_ground = true;
};

/// What the blocks `own` show above the upper envelope of the blocks `below`, or above the height
/// `base` where none of those stands. House frame. See solids_over_plan.
///
/// With a `cover` only what lies inside its outline, and blocks on the ground reach beyond their
/// rectangles as outline_margins.h says.
std::optional<std::vector<Solid>> solids_above(const std::vector<PartBlock>& own,
                                               const std::vector<PartBlock>& below, double base,
                                               const OutlineCover* cover = nullptr);

}  // namespace gable
