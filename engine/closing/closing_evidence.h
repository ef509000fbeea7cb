#pragma once

#include <gable/engine/closing/plan_lines.h>

#include <Eigen/Geometry>
#include <vector>

namespace gable {

/// What is known of a roof besides its planes and heights. Local frame, metres.
struct ClosingEvidence {
  /// Where walls stand, with the stretches that were seen of them: the plan is divided along them
  /// first, those first given before the others.
  std::vector<PlanLine> traces;
  /// Per plane the part of space where it may be the roof, or none at all: everywhere.
  std::vector<Eigen::AlignedBox3d> reaches;
};

}  // namespace gable
