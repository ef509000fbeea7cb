#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/solid/extrusion.h>

#include <vector>

namespace gable {

/// An outline with those edges moved onto the traces of walls that run beside them: edges of which
/// neither end is farther than `distance`, metres, from a trace that was seen along half of the
/// edge at least. Corners become the crossings of their edges; where neighbouring edges follow one
/// trace there is none left, and where they are as good as parallel a corner becomes the two feet
/// on them. A ring that would cross itself, or whose corners would go farther than 3 `distance`,
/// stays as it was. Local frame, metres.
PlanPolygon traced_outline(const PlanPolygon& outline, const std::vector<PlanLine>& traces,
                           double distance);

}  // namespace gable
