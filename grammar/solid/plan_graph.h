#pragma once

#include <gable/grammar/ring.h>
#include <gable/grammar/solid/plane.h>

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gable {

/// A straight line between two points of the plan, metres.
struct PlanSegment {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
};

/// What stands over a place of the plan: the solid between two planes, or nothing.
struct CellLabel {
  int upper = -1;  ///< number of the plane above, -1 where nothing stands
  int lower = -1;  ///< number of the plane below

  bool empty() const { return upper < 0; }
  bool operator==(const CellLabel&) const = default;
};

/// Adds the edges of a closed ring.
void append_ring(const Ring& ring, std::vector<PlanSegment>* segments);

/// Adds the edges of several closed rings, such as the holes of a polygon.
void append_rings(std::span<const Ring> rings, std::vector<PlanSegment>* segments);

using LabelFunction = std::function<CellLabel(const Eigen::Vector2d&)>;

/// A line of the plan across which the label changes.
struct PlanEdge {
  int from = 0, to = 0;                 ///< vertices
  CellLabel left, right;                ///< seen along from -> to
  int left_cell = -1, right_cell = -1;  ///< cells, -1 where nothing stands
};

/// A connected region of one label. rings[0] is anticlockwise, the others (holes) clockwise.
struct PlanCell {
  CellLabel label;
  std::vector<std::vector<int>> rings;
};

/// The plan divided into regions of equal label. Conforming: edges meet in vertices only.
struct PlanGraph {
  std::vector<Eigen::Vector2d> vertices;
  std::vector<PlanEdge> edges;
  std::vector<PlanCell> cells;
};

/// Divides the plan along those parts of `segments` across which `label` changes, and wherever
/// two of the `planes` named beside an edge cross along it. Points nearer than 2 micrometres become
/// one. Returns nothing where the labels contradict each other, which is a sign of features finer
/// than 0.02 mm.
std::optional<PlanGraph> divide_plan(const std::vector<PlanSegment>& segments,
                                     const LabelFunction& label, const std::vector<Plane>& planes);

}  // namespace gable
