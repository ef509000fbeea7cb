#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/engine/plan_overlay.h>

#include <functional>
#include <vector>

namespace gable {

/// A house in plan.
struct PlanHouse {
  PlanShape plan;  ///< what it covers
  /// The lines that a row was cut along to get it (row_cuts.h): it lies on their negative sides,
  /// and its neighbours have the same lines turned round.
  std::vector<PlanLine> cuts;
};

/// The plans of houses without what they take of each other. Of ground that two of them cover each
/// keeps its side of the cut between them; where there is none, each connected piece stays with the
/// house that has the larger claim to it, the first of equals. claim(house, polygon): the area of a
/// polygon that was seen to be the house's, square metres. Houses in one frame, metres; in their
/// order.
std::vector<PlanShape> divided_ground(
    const std::vector<PlanHouse>& houses,
    const std::function<double(size_t, const PlanPolygon&)>& claim);

}  // namespace gable
