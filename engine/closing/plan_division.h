#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plan_graph.h>

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

namespace gable {

/// A straight border between two cells.
struct CellBorder {
  int a = 0, b = 0;  ///< cells
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
};

/// The inside of an outline (even-odd over its rings) divided into cells by straight lines that run
/// across all of it. Local frame, metres.
class PlanDivision {
 public:
  /// Nothing where lines and outline have features finer than 0.02 mm (see divide_plan). Points of
  /// the outline nearer than 5 mm to the one before are left out.
  static std::optional<PlanDivision> make(const PlanPolygon& outline,
                                          const std::vector<PlanLine>& lines);

  int num_cells() const { return static_cast<int>(cells_.size()); }
  const std::vector<CellBorder>& borders() const { return borders_; }
  /// Corners of a cell, those of its holes too.
  std::vector<Eigen::Vector2d> corners(int cell) const;
  double area(int cell) const;  ///< square metres
  /// The cell that holds a point, -1 outside the outline.
  int cell_at(const Eigen::Vector2d& p) const;
  /// Everything that cells end at: the outline and the lines.
  const std::vector<PlanSegment>& segments() const { return segments_; }

 private:
  using Sides = std::vector<bool>;

  Sides sides_of(const Eigen::Vector2d& p) const;
  bool holds(const Eigen::Vector2d& p) const;

  std::vector<Ring> outline_;
  std::vector<PlanLine> lines_;
  std::vector<PlanSegment> segments_;
  std::vector<std::vector<Ring>> cells_;
  std::vector<CellBorder> borders_;
  std::map<Sides, std::vector<int>> cells_of_sides_;
};

}  // namespace gable
