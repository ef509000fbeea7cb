#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plan_graph.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A straight border between two cells.
struct CellBorder {
  int a = 0, b = 0;  ///< cells
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
};

/// The inside of an outline (even-odd over its rings) divided into cells by straight lines. Line
/// after line cuts those of the convex regions so far that it was seen in, each from side to side:
/// a binary space partition. So lines that were seen everywhere make their whole arrangement, and
/// others end at the first earlier line beyond what was seen of them. Lines of steps are moved by
/// up to 3 cm to pass earlier corners exactly or 5 mm clear. Local frame, metres.
class PlanDivision {
 public:
  /// Nothing where lines and outline have features finer than 0.02 mm (see divide_plan). Points of
  /// the outline nearer than 5 mm to the one before are left out, and no region gets a strip
  /// thinner than 5 mm.
  static std::optional<PlanDivision> make(const PlanPolygon& outline,
                                          const std::vector<PlanLine>& lines);

  int num_cells() const { return static_cast<int>(cells_.size()); }
  const std::vector<CellBorder>& borders() const { return borders_; }
  /// Corners of a cell, those of its holes too.
  std::vector<Eigen::Vector2d> corners(int cell) const;
  double area(int cell) const;  ///< square metres
  /// The cell that holds a point, -1 outside the outline.
  int cell_at(const Eigen::Vector2d& p) const;
  /// A point well inside a cell.
  Eigen::Vector2d inside(int cell) const;
  /// Everything that cells end at: the outline and the stretches of the lines.
  const std::vector<PlanSegment>& segments() const { return segments_; }
  /// Numbers of the lines with a stretch within `distance` of a point, in order.
  std::vector<int> lines_near(const Eigen::Vector2d& p, double distance) const;

 private:
  /// A region that a line cuts in two, or a leaf of the partition.
  struct Region {
    int line = -1;                // -1: a leaf
    int behind = -1, front = -1;  // regions on either side of the line
    Ring ring;                    // of a leaf, anticlockwise
  };

  double clear_offset(const PlanLine& line) const;
  void cut(int line);
  int leaf_of(const Eigen::Vector2d& p) const;
  bool holds(const Eigen::Vector2d& p) const;

  std::vector<Ring> outline_;
  std::vector<PlanLine> lines_;
  std::vector<Region> regions_;
  std::vector<Eigen::Vector2d> corners_;  // so far, while lines cut
  std::vector<PlanSegment> segments_;
  std::vector<int> lines_of_segments_;  // -1: the outline
  std::vector<std::vector<Ring>> cells_;
  std::vector<CellBorder> borders_;
  std::vector<std::vector<int>> cells_of_region_;
};

}  // namespace gable
