#pragma once

#include <gable/engine/closing/closing_options.h>
#include <gable/engine/closing/sample_grid.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plane.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A straight line of the plan, the points p with normal . p = offset; local frame, metres.
struct PlanLine {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit
  double offset = 0.0;
  /// The planes that meet along it (a ridge, hip or valley); -1 for the line of a step.
  int a = -1, b = -1;

  double signed_distance(const Eigen::Vector2d& p) const { return normal.dot(p) - offset; }
  bool is_crease() const { return a >= 0; }
};

/// The line along which two planes meet; nothing where they are as good as parallel.
std::optional<PlanLine> crease_of(const std::vector<Plane>& planes, int a, int b);

/// The lines that divide the plan between planes: the creases of those neighbours in the labelled
/// grid whose border runs along their crease, then lines through what is left of the borders, those
/// of most cells first, preferably along directions of the outline and the planes; and at last
/// edges of the outline beyond its re-entrant corners, longest first. At most options.max_lines.
std::vector<PlanLine> find_plan_lines(const SampleGrid& grid, const std::vector<int>& labels,
                                      const std::vector<Plane>& planes, const PlanPolygon& outline,
                                      const ClosingOptions& options);

}  // namespace gable
