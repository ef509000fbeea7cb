#include <gable/engine/closing/plan_division.h>

#include <cmath>
#include <limits>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastSpacing = 0.005;  // between points of the outline, metres
constexpr double kBeyond = 0.5;          // how far lines reach beyond the outline, metres

Ring spaced(const Ring& ring) {
  Ring kept;
  for (const Eigen::Vector2d& p : ring) {
    if (kept.empty() || (p - kept.back()).norm() > kLeastSpacing) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= kLeastSpacing) kept.pop_back();
  return kept;
}

// The part of a line over a box; nothing where it misses the box.
std::optional<PlanSegment> clipped(const PlanLine& line, const Eigen::Vector2d& low,
                                   const Eigen::Vector2d& high) {
  const Eigen::Vector2d along(-line.normal.y(), line.normal.x());
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const Eigen::Vector2d foot = middle - line.signed_distance(middle) * line.normal;
  double begin = -std::numeric_limits<double>::infinity(), end = -begin;
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(along[axis]) < 1e-12) {
      if (foot[axis] < low[axis] || foot[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double first = (low[axis] - foot[axis]) / along[axis];
    const double last = (high[axis] - foot[axis]) / along[axis];
    begin = std::max(begin, std::min(first, last));
    end = std::min(end, std::max(first, last));
  }
  if (!(begin < end)) return std::nullopt;
  return PlanSegment{foot + begin * along, foot + end * along};
}

}  // namespace

PlanDivision::Sides PlanDivision::sides_of(const Eigen::Vector2d& p) const {
  Sides sides(lines_.size());
  for (size_t i = 0; i < lines_.size(); ++i) sides[i] = lines_[i].signed_distance(p) > 0.0;
  return sides;
}

bool PlanDivision::holds(const Eigen::Vector2d& p) const { return rings_hold(outline_, p); }

std::optional<PlanDivision> PlanDivision::make(const PlanPolygon& outline,
                                               const std::vector<PlanLine>& lines) {
  PlanDivision division;
  division.lines_ = lines;
  std::vector<const Ring*> rings = {&outline.outer};
  for (const Ring& hole : outline.holes) rings.push_back(&hole);
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const Ring* ring : rings) {
    for (const Eigen::Vector2d& p : *ring) {
      if (!p.allFinite()) return std::nullopt;
    }
    Ring kept = spaced(*ring);
    if (kept.size() < 3) continue;
    for (size_t i = 0; i < kept.size(); ++i) {
      low = low.cwiseMin(kept[i]);
      high = high.cwiseMax(kept[i]);
      division.segments_.push_back({kept[i], kept[(i + 1) % kept.size()]});
    }
    division.outline_.push_back(std::move(kept));
  }
  if (division.outline_.empty()) return std::nullopt;
  low.array() -= kBeyond;
  high.array() += kBeyond;
  for (const PlanLine& line : lines) {
    if (const auto segment = clipped(line, low, high)) division.segments_.push_back(*segment);
  }

  // A number for every set of sides: connected places of one number are a cell. All cells share one
  // height, so that nothing is cut for the heights' sake.
  std::map<Sides, int> numbers;
  const auto label = [&](const Eigen::Vector2d& p) {
    if (!division.holds(p)) return CellLabel{};
    const int next = static_cast<int>(numbers.size());
    return CellLabel{numbers.try_emplace(division.sides_of(p), next).first->second, 0};
  };
  // No more sets of sides than cells of an arrangement of lines.
  const size_t n = lines.size();
  const std::vector<Plane> flat(1 + n * (n + 1) / 2 + 1);
  const std::optional<PlanGraph> graph = divide_plan(division.segments_, label, flat);
  if (!graph || graph->cells.empty()) return std::nullopt;
  std::vector<const Sides*> sides(numbers.size());
  for (const auto& [key, number] : numbers) sides[number] = &key;
  for (const PlanCell& cell : graph->cells) {
    division.cells_of_sides_[*sides[cell.label.upper]].push_back(division.num_cells());
    std::vector<Ring>& cell_rings = division.cells_.emplace_back();
    for (const std::vector<int>& ring : cell.rings) {
      Ring& points = cell_rings.emplace_back();
      for (const int v : ring) points.push_back(graph->vertices[v]);
    }
  }
  for (const PlanEdge& edge : graph->edges) {
    if (edge.left_cell < 0 || edge.right_cell < 0 || edge.left_cell == edge.right_cell) continue;
    division.borders_.push_back(
        {edge.left_cell, edge.right_cell, graph->vertices[edge.from], graph->vertices[edge.to]});
  }
  return division;
}

std::vector<Eigen::Vector2d> PlanDivision::corners(int cell) const {
  std::vector<Eigen::Vector2d> points;
  for (const Ring& ring : cells_[cell]) points.insert(points.end(), ring.begin(), ring.end());
  return points;
}

double PlanDivision::area(int cell) const {
  double area = 0.0;
  for (const Ring& ring : cells_[cell]) area += signed_area(ring);
  return area;
}

int PlanDivision::cell_at(const Eigen::Vector2d& p) const {
  if (!holds(p)) return -1;
  const auto found = cells_of_sides_.find(sides_of(p));
  if (found == cells_of_sides_.end()) return -1;
  if (found->second.size() == 1) return found->second.front();
  for (const int cell : found->second) {
    if (rings_hold(cells_[cell], p)) return cell;
  }
  return -1;
}

}  // namespace gable
