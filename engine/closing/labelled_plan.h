#pragma once

#include <gable/engine/closing/plan_division.h>
#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plane.h>
#include <gable/grammar/solid/roof_partition.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace gable {

/// The planes that may be used, with the numbers of those given and where they may be used. Local
/// frame, metres.
struct PlaneChoice {
  std::vector<Plane> planes;
  std::vector<int> origins;                  ///< -1: a level one that stands in
  std::vector<Eigen::AlignedBox3d> reaches;  ///< parts of space where they may be the roof

  void add(const Plane& plane, int origin, const Eigen::AlignedBox3d& reach);
};

/// A division with a plane for every cell. Local frame, metres.
struct LabelledPlan {
  PlanPolygon outline;
  std::vector<PlanLine> lines;  ///< of planes by their number at the time
  PlanDivision division;
  std::vector<int> labels;  ///< numbers of planes
  double cost = 0.0;        ///< of the labels, cubic metres
};

/// The planes without those that no cell uses; the numbers in `labelled` follow, and creases of
/// planes that are left out become lines of steps.
PlaneChoice used_planes(const PlaneChoice& choice, LabelledPlan* labelled);

/// The regions of a labelled division; nothing where they contradict each other.
std::optional<RoofPartition> partition_of(const LabelledPlan& labelled,
                                          const std::vector<Plane>& planes);

}  // namespace gable
