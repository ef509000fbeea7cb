#pragma once

#include <gable/engine/solver/plane_refinement.h>
#include <gable/engine/solver/plane_regularities.h>

#include <string>

namespace gable {

/// How planes are closed into a roof. Costs are in cubic metres: what heights miss, summed over the
/// plan, is a volume, and everything else is weighed against it.
struct ClosingOptions {
  /// Misses much smaller than this cost little, larger ones twice their size, metres, (0, 100].
  double loss_scale = 0.3;
  double boundary_cost = 0.1;  ///< per metre of a boundary between regions, [0, 1000]
  double step_cost = 0.1;      ///< per square metre of the wall where heights step, [0, 1000]
  double plane_charge = 1.0;   ///< per plane that is used at all, [0, 1e6]
  /// Borders between planes that meet at no crease get a line where they are this long, metres,
  /// (0, 1000].
  double least_step_length = 1.5;
  /// A line of a step as near as this to a parallel edge of the outline takes its place, metres,
  /// [0, 100].
  double snap_distance = 0.3;
  int max_lines = 40;      ///< that divide the plan, [0, 2000]
  int max_grid = 4000;     ///< cells of the grid that finds which planes are neighbours, [16, 1e6]
  int max_refits = 4;      ///< of the planes to the regions they got, [0, 100]
  double clearance = 0.1;  ///< least height of the roof above its base, metres, [0.01, 100]
  double headroom = 2.0;   ///< of the roof above the highest sample, metres, [0, 1000]
  PlaneRefinementOptions refinement = {.loss_scale = 0.3};
  RegularityOptions regularities = {};
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ClosingOptions& options);

}  // namespace gable
