#pragma once

#include <gable/engine/closing/closing_options.h>
#include <gable/engine/closing/sample_grid.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plane.h>

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

namespace gable {

/// A straight line of the plan, the points p with normal . p = offset; local frame, metres.
struct PlanLine {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit
  double offset = 0.0;
  /// The planes that meet along it (a ridge, hip or valley); -1 for the line of a step.
  int a = -1, b = -1;
  /// Where something was seen of it, metres along it (see `along`).
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();

  double signed_distance(const Eigen::Vector2d& p) const { return normal.dot(p) - offset; }
  bool is_crease() const { return a >= 0; }
  /// The place along the line nearest to a point, metres from that nearest to the origin.
  double along(const Eigen::Vector2d& p) const { return direction().dot(p); }
  Eigen::Vector2d direction() const { return {-normal.y(), normal.x()}; }
  Eigen::Vector2d at(double along) const { return offset * normal + along * direction(); }
};

/// The line along which two planes meet; nothing where they are as good as parallel.
std::optional<PlanLine> crease_of(const std::vector<Plane>& planes, int a, int b);

/// The lines that divide the plan between planes, with the stretches where they were seen: `traces`
/// of walls, as they are; the creases of those neighbours in the labelled grid whose border runs
/// along their crease; lines along what is left of the borders, the longest unbroken stretches
/// first, preferably along directions of the outline and the planes; and at last edges of the
/// outline beyond its re-entrant corners, longest first. At most options.max_lines.
std::vector<PlanLine> find_plan_lines(const SampleGrid& grid, const std::vector<int>& labels,
                                      const std::vector<Plane>& planes, const PlanPolygon& outline,
                                      const std::vector<PlanLine>& traces,
                                      const ClosingOptions& options);

}  // namespace gable
