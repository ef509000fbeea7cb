#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/ring.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gable {
namespace {

// Slopes that differ by less than this meet nowhere in particular.
constexpr double kLeastSlopeDifference = 0.05;

// Where two planes meet is known to about this height over the difference of their slopes, metres.
constexpr double kHeightTolerance = 0.1;

// Lines that turn by less than this, radians, and run this near, metres, are one.
constexpr double kSameAngle = 0.05;
constexpr double kSameOffset = 0.3;

// Free directions that are tried, and what regular ones count more.
constexpr int kNumFreeDirections = 24;
constexpr double kOutlineBonus = 1.2;
constexpr double kPlaneBonus = 1.1;

// Edges of the outline this long, metres, go on beyond corners that turn back by this, radians; as
// one where they are this near, metres.
constexpr double kLeastReentrantEdge = 0.5;
constexpr double kLeastTurn = 0.3;
constexpr double kSameReentrant = 0.1;

constexpr double kLeastOutlineEdge = 2.0;  // metres, for its direction to count

using Points = std::vector<Eigen::Vector2d>;

/// Middles of the sides between cells of different planes, by the planes (less number first).
std::map<std::pair<int, int>, Points> borders_of(const SampleGrid& grid,
                                                 const std::vector<int>& labels) {
  std::map<std::pair<int, int>, Points> borders;
  const auto add = [&](int label, int other, const Eigen::Vector2d& middle) {
    if (label >= 0 && other >= 0 && label != other) {
      borders[std::minmax(label, other)].push_back(middle);
    }
  };
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const int label = labels[grid.index(row, col)];
      const Eigen::Vector2d center = grid.center(row, col);
      if (col + 1 < grid.cols) {
        add(label, labels[grid.index(row, col + 1)],
            center + Eigen::Vector2d(0.5 * grid.cell, 0.0));
      }
      if (row + 1 < grid.rows) {
        add(label, labels[grid.index(row + 1, col)],
            center + Eigen::Vector2d(0.0, 0.5 * grid.cell));
      }
    }
  }
  return borders;
}

Points away_from(const PlanLine& line, double distance, const Points& points) {
  Points left;
  for (const Eigen::Vector2d& p : points) {
    if (std::abs(line.signed_distance(p)) > distance) left.push_back(p);
  }
  return left;
}

Eigen::Vector2d normal_of_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

struct Direction {
  Eigen::Vector2d normal;
  double bonus;
  bool free;
};

std::vector<PlanLine> edge_lines_of(const PlanPolygon& outline, double least_length) {
  std::vector<PlanLine> lines;
  const auto add = [&](const std::vector<Eigen::Vector2d>& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - ring[i];
      if (along.norm() < least_length) continue;
      const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
      lines.push_back({normal, normal.dot(ring[i])});
    }
  };
  add(outline.outer);
  for (const auto& hole : outline.holes) add(hole);
  return lines;
}

std::vector<Direction> directions_of(const std::vector<PlanLine>& edges,
                                     const std::vector<Plane>& planes) {
  std::vector<Direction> directions;
  const auto add = [&](const Eigen::Vector2d& normal, double bonus) {
    for (const Direction& known : directions) {
      const double sine = known.normal.x() * normal.y() - known.normal.y() * normal.x();
      if (std::abs(sine) < 0.5 * kSameAngle) return;
    }
    directions.push_back({normal, bonus, false});
  };
  for (const PlanLine& edge : edges) add(edge.normal, kOutlineBonus);
  for (const Plane& plane : planes) {
    const Eigen::Vector2d slope(plane.a, plane.b);
    if (slope.norm() < kLeastSlopeDifference) continue;
    add(slope.normalized(), kPlaneBonus);
    add(Eigen::Vector2d(-slope.y(), slope.x()).normalized(), kPlaneBonus);
  }
  for (int i = 0; i < kNumFreeDirections; ++i) {
    directions.push_back({normal_of_angle(i * M_PI / kNumFreeDirections), 1.0, true});
  }
  return directions;
}

/// The points within a window of offsets along a direction.
struct Window {
  double score = 0.0;
  double low = 0.0, high = 0.0;
  const Direction* direction = nullptr;
};

Window best_window(const Points& points, const std::vector<Direction>& directions, double width) {
  Window best;
  std::vector<double> offsets(points.size());
  for (const Direction& direction : directions) {
    for (size_t i = 0; i < points.size(); ++i) offsets[i] = direction.normal.dot(points[i]);
    std::sort(offsets.begin(), offsets.end());
    for (size_t first = 0, end = 0; first < offsets.size(); ++first) {
      while (end < offsets.size() && offsets[end] <= offsets[first] + width) ++end;
      const double score = direction.bonus * static_cast<double>(end - first);
      if (score > best.score) best = {score, offsets[first], offsets[end - 1], &direction};
    }
  }
  return best;
}

/// Least squares in total through points.
PlanLine line_through(const Points& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Eigen::Vector2d normal = normal_of_angle(along + M_PI / 2);
  return {normal, normal.dot(mean)};
}

bool runs_along(const PlanLine& line, const PlanLine& other, const Eigen::Vector2d& at,
                double distance, double angle) {
  const double sine = line.normal.x() * other.normal.y() - line.normal.y() * other.normal.x();
  return std::abs(sine) < std::sin(angle) && std::abs(other.signed_distance(at)) < distance;
}

/// The lines of those edges that end at a corner of more than 180 degrees, where the outline itself
/// suggests that parts meet; longest first.
std::vector<PlanLine> reentrant_lines(const PlanPolygon& outline) {
  std::vector<std::pair<double, PlanLine>> found;
  const auto add = [&](const Ring& ring, bool hole) {
    const double inside_left = (signed_area(ring) > 0.0) != hole ? 1.0 : -1.0;
    const size_t n = ring.size();
    std::vector<bool> reentrant(n);
    for (size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d before = (ring[i] - ring[(i + n - 1) % n]).normalized();
      const Eigen::Vector2d after = (ring[(i + 1) % n] - ring[i]).normalized();
      const double sine = before.x() * after.y() - before.y() * after.x();
      reentrant[i] = inside_left * sine < -std::sin(kLeastTurn);
    }
    for (size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d along = ring[(i + 1) % n] - ring[i];
      if (!(reentrant[i] || reentrant[(i + 1) % n]) || along.norm() < kLeastReentrantEdge) continue;
      const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
      found.push_back({along.norm(), {normal, normal.dot(ring[i])}});
    }
  };
  add(outline.outer, false);
  for (const Ring& hole : outline.holes) add(hole, true);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  std::vector<PlanLine> lines;
  for (const auto& [length, line] : found) lines.push_back(line);
  return lines;
}

}  // namespace

std::optional<PlanLine> crease_of(const std::vector<Plane>& planes, int a, int b) {
  const Eigen::Vector2d slope(planes[a].a - planes[b].a, planes[a].b - planes[b].b);
  const double norm = slope.norm();
  if (norm < kLeastSlopeDifference) return std::nullopt;
  return PlanLine{slope / norm, (planes[b].c - planes[a].c) / norm, a, b};
}

std::vector<PlanLine> find_plan_lines(const SampleGrid& grid, const std::vector<int>& labels,
                                      const std::vector<Plane>& planes, const PlanPolygon& outline,
                                      const ClosingOptions& options) {
  struct Crease {
    PlanLine line;
    size_t support;
  };
  std::vector<Crease> creases;
  Points steps;
  for (auto& [pair, points] : borders_of(grid, labels)) {
    const std::optional<PlanLine> crease = crease_of(planes, pair.first, pair.second);
    if (!crease) {
      steps.insert(steps.end(), points.begin(), points.end());
      continue;
    }
    const double slope = std::hypot(planes[pair.first].a - planes[pair.second].a,
                                    planes[pair.first].b - planes[pair.second].b);
    const double tolerance = 1.5 * grid.cell + std::min(1.0, kHeightTolerance / slope);
    const Points left = away_from(*crease, tolerance, points);
    const size_t support = points.size() - left.size();
    if (support >= 2) creases.push_back({*crease, support});
    steps.insert(steps.end(), left.begin(), left.end());
  }
  std::stable_sort(creases.begin(), creases.end(),
                   [](const Crease& x, const Crease& y) { return x.support > y.support; });
  std::vector<PlanLine> lines;
  for (const Crease& crease : creases) {
    if (static_cast<int>(lines.size()) == options.max_lines) return lines;
    lines.push_back(crease.line);
    steps = away_from(crease.line, grid.cell, steps);
  }

  const std::vector<PlanLine> edges = edge_lines_of(outline, kLeastOutlineEdge);
  const std::vector<Direction> directions = directions_of(edges, planes);
  while (static_cast<int>(lines.size()) < options.max_lines) {
    const Window window = best_window(steps, directions, 2.0 * grid.cell);
    if (!window.direction) break;
    Points on;
    for (const Eigen::Vector2d& p : steps) {
      const double offset = window.direction->normal.dot(p);
      if (offset >= window.low && offset <= window.high) on.push_back(p);
    }
    if (static_cast<double>(on.size()) * grid.cell < options.least_step_length) break;
    PlanLine line = line_through(on);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : on) mean += p / static_cast<double>(on.size());
    if (!window.direction->free) {
      line.normal = window.direction->normal;
      line.offset = line.normal.dot(mean);
    }
    for (const PlanLine& edge : edges) {
      if (!runs_along(line, edge, mean, options.snap_distance, 3.0 * kSameAngle)) continue;
      line = edge;
      break;
    }
    const size_t before = steps.size();
    std::erase_if(steps, [&](const Eigen::Vector2d& p) {
      const double offset = window.direction->normal.dot(p);
      return (offset >= window.low && offset <= window.high) ||
             std::abs(line.signed_distance(p)) <= grid.cell;
    });
    if (steps.size() == before) break;
    const bool known = std::any_of(lines.begin(), lines.end(), [&](const PlanLine& other) {
      return runs_along(line, other, mean, kSameOffset, kSameAngle);
    });
    if (!known) lines.push_back(line);
  }
  for (const PlanLine& line : reentrant_lines(outline)) {
    if (static_cast<int>(lines.size()) >= options.max_lines) break;
    const auto same = [&](const PlanLine& other) {
      return runs_along(line, other, line.offset * line.normal, kSameReentrant, kSameAngle);
    };
    if (std::none_of(lines.begin(), lines.end(), same)) lines.push_back(line);
  }
  return lines;
}

}  // namespace gable
