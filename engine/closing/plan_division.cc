#include <gable/engine/closing/plan_division.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastSpacing = 0.005;  // between points of the outline, metres
constexpr double kThinnest = 0.005;      // strip of a region that is cut off, metres
// Lines of steps keep this clear of corners that they do not go through, metres, where moving them
// by so much is enough.
constexpr double kClearance = 0.005;
constexpr double kSameCorner = 1e-7;
constexpr double kMostNudge = 0.03;

constexpr double kBeyond = 0.5;  // how far lines reach beyond the outline, metres

Ring spaced(const Ring& ring) {
  Ring kept;
  for (const Eigen::Vector2d& p : ring) {
    if (kept.empty() || (p - kept.back()).norm() > kLeastSpacing) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= kLeastSpacing) kept.pop_back();
  return kept;
}

/// The stretch of a line over a convex ring, from its begin to its end; nothing where the line does
/// not cut it.
std::optional<PlanSegment> stretch_over(const PlanLine& line, const Ring& ring) {
  std::vector<Eigen::Vector2d> ends;
  double low = 0.0, high = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = line.signed_distance(p), at_q = line.signed_distance(q);
    low = std::min(low, at_p);
    high = std::max(high, at_p);
    if ((at_p > 0.0) != (at_q > 0.0)) ends.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  if (ends.size() != 2 || low > -kThinnest || high < kThinnest) return std::nullopt;
  if (line.along(ends[0]) > line.along(ends[1])) std::swap(ends[0], ends[1]);
  return PlanSegment{ends[0], ends[1]};
}

/// Where two segments cross inside both.
std::optional<Eigen::Vector2d> crossing(const PlanSegment& s, const PlanSegment& t) {
  const Eigen::Vector2d ds = s.to - s.from, dt = t.to - t.from, between = t.from - s.from;
  const double sine = ds.x() * dt.y() - ds.y() * dt.x();
  if (std::abs(sine) < 1e-10 * ds.norm() * dt.norm()) return std::nullopt;
  const double at_s = (between.x() * dt.y() - between.y() * dt.x()) / sine;
  const double at_t = (between.x() * ds.y() - between.y() * ds.x()) / sine;
  if (at_s <= 0.0 || at_s >= 1.0 || at_t <= 0.0 || at_t >= 1.0) return std::nullopt;
  return s.from + at_s * ds;
}

/// The part of a convex ring on the side of a line where `side` times the distance is positive.
Ring part_of(const Ring& ring, const PlanLine& line, double side) {
  Ring part;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = line.signed_distance(p), at_q = line.signed_distance(q);
    if (side * at_p > 0.0) part.push_back(p);
    if ((at_p > 0.0) != (at_q > 0.0)) part.push_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return part;
}

}  // namespace

double PlanDivision::clear_offset(const PlanLine& line) const {
  // Signed distances of the corners so far that the line passes.
  std::vector<double> passed;
  for (const Eigen::Vector2d& corner : corners_) {
    const double along = line.along(corner), distance = line.signed_distance(corner);
    if (std::abs(distance) < 2.0 * kMostNudge && along > line.begin && along < line.end) {
      passed.push_back(distance);
    }
  }
  const auto is_clear = [&](double nudge) {
    return std::none_of(passed.begin(), passed.end(), [&](double distance) {
      const double off = std::abs(distance - nudge);
      return off > kSameCorner && off < kClearance;
    });
  };
  double best = 0.0;
  if (is_clear(best)) return line.offset;
  best = std::numeric_limits<double>::infinity();
  for (const double distance : passed) {
    for (const double nudge : {distance - 1.01 * kClearance, distance + 1.01 * kClearance}) {
      if (std::abs(nudge) < std::min(kMostNudge, std::abs(best)) && is_clear(nudge)) best = nudge;
    }
  }
  return line.offset + (std::isfinite(best) ? best : 0.0);
}

void PlanDivision::cut(int number) {
  PlanLine& line = lines_[number];
  const auto is_cut = [&](const PlanSegment& stretch) {
    return line.along(stretch.to) >= line.begin && line.along(stretch.from) <= line.end;
  };
  // As far as the line cuts regions, to know what it passes.
  PlanLine reaching = line;
  for (const Region& region : regions_) {
    if (region.line >= 0) continue;
    const std::optional<PlanSegment> stretch = stretch_over(line, region.ring);
    if (!stretch || !is_cut(*stretch)) continue;
    reaching.begin = std::min(reaching.begin, line.along(stretch->from) - kClearance);
    reaching.end = std::max(reaching.end, line.along(stretch->to) + kClearance);
  }
  if (!line.is_crease()) line.offset = clear_offset(reaching);
  const int count = static_cast<int>(regions_.size());
  for (int r = 0; r < count; ++r) {
    if (regions_[r].line >= 0) continue;
    const std::optional<PlanSegment> stretch = stretch_over(line, regions_[r].ring);
    if (!stretch || !is_cut(*stretch)) continue;
    Region behind, front;
    behind.ring = part_of(regions_[r].ring, line, -1.0);
    front.ring = part_of(regions_[r].ring, line, 1.0);
    segments_.push_back(*stretch);
    lines_of_segments_.push_back(number);
    corners_.push_back(stretch->from);
    corners_.push_back(stretch->to);
    for (const Ring& ring : outline_) {
      for (size_t i = 0; i < ring.size(); ++i) {
        if (const auto corner = crossing(*stretch, {ring[i], ring[(i + 1) % ring.size()]})) {
          corners_.push_back(*corner);
        }
      }
    }
    regions_[r].line = number;
    regions_[r].ring.clear();
    regions_[r].behind = static_cast<int>(regions_.size());
    regions_[r].front = regions_[r].behind + 1;
    regions_.push_back(std::move(behind));
    regions_.push_back(std::move(front));
  }
}

int PlanDivision::leaf_of(const Eigen::Vector2d& p) const {
  int region = 0;
  while (regions_[region].line >= 0) {
    const bool front = lines_[regions_[region].line].signed_distance(p) > 0.0;
    region = front ? regions_[region].front : regions_[region].behind;
  }
  return region;
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
      division.lines_of_segments_.push_back(-1);
      division.corners_.push_back(kept[i]);
    }
    division.outline_.push_back(std::move(kept));
  }
  if (division.outline_.empty()) return std::nullopt;
  low.array() -= kBeyond;
  high.array() += kBeyond;
  division.regions_.push_back({});
  division.regions_[0].ring = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (size_t i = 0; i < lines.size(); ++i) division.cut(static_cast<int>(i));

  // Connected places of one region are a cell. All cells share one height, so that nothing is cut
  // for the heights' sake.
  const auto label = [&](const Eigen::Vector2d& p) {
    return division.holds(p) ? CellLabel{division.leaf_of(p), 0} : CellLabel{};
  };
  const std::vector<Plane> flat(division.regions_.size());
  const std::optional<PlanGraph> graph = divide_plan(division.segments_, label, flat);
  if (!graph || graph->cells.empty()) return std::nullopt;
  division.cells_of_region_.resize(division.regions_.size());
  for (const PlanCell& cell : graph->cells) {
    division.cells_of_region_[cell.label.upper].push_back(division.num_cells());
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
  const std::vector<int>& found = cells_of_region_[leaf_of(p)];
  if (found.size() == 1) return found.front();
  for (const int cell : found) {
    if (rings_hold(cells_[cell], p)) return cell;
  }
  return -1;
}

std::vector<int> PlanDivision::lines_near(const Eigen::Vector2d& p, double distance) const {
  std::vector<int> near;
  for (size_t i = 0; i < segments_.size(); ++i) {
    const int number = lines_of_segments_[i];
    if (number < 0) continue;
    const PlanLine& line = lines_[number];
    if (std::abs(line.signed_distance(p)) < distance &&
        line.along(p) > line.along(segments_[i].from) - distance &&
        line.along(p) < line.along(segments_[i].to) + distance) {
      near.push_back(number);
    }
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

Eigen::Vector2d PlanDivision::inside(int cell) const {
  // The middle of the widest stretch that the cell has at half its height.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& p : cells_[cell][0]) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  const double y = 0.5 * (low + high);
  std::vector<double> crossings;
  for (const Ring& ring : cells_[cell]) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &p = ring[i], &q = ring[(i + 1) % ring.size()];
      if ((p.y() > y) == (q.y() > y)) continue;
      crossings.push_back(p.x() + (q.x() - p.x()) * (y - p.y()) / (q.y() - p.y()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  double widest = -1.0;
  Eigen::Vector2d middle = cells_[cell][0][0];
  for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] <= widest) continue;
    widest = crossings[i + 1] - crossings[i];
    middle = {0.5 * (crossings[i] + crossings[i + 1]), y};
  }
  return middle;
}

}  // namespace gable
