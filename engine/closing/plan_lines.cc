#include <gable/engine/closing/plan_lines.h>
#include <gable/grammar/ring.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace gable {
namespace {

// Slopes that differ by less than this meet nowhere in particular.
constexpr double kLeastSlopeDifference = 0.05;

// Where two planes meet is known to about this height over the difference of their slopes, metres.
constexpr double kHeightTolerance = 0.1;

// Lines that turn by less than this, radians, and run near each other are one.
constexpr double kSameAngle = 0.05;

// Free directions that are tried, and what regular ones count more.
constexpr int kNumFreeDirections = 24;
constexpr double kOutlineBonus = 1.2;
constexpr double kPlaneBonus = 1.1;

// Edges of the outline this long, metres, go on beyond corners that turn back by this, radians; as
// one where they are this near, metres.
constexpr double kLeastReentrantEdge = 0.5;
constexpr double kLeastTurn = 0.3;
constexpr double kSameReentrant = 0.1;
constexpr double kBeyondCorner = 0.5;

// Cells without a border point that a stretch of a line may span.
constexpr double kGapCells = 3.0;

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

/// The points that do not lie along the stretch of a line.
Points away_from(const PlanLine& line, double distance, const Points& points) {
  Points left;
  for (const Eigen::Vector2d& p : points) {
    const double along = line.along(p);
    if (std::abs(line.signed_distance(p)) > distance || along < line.begin || along > line.end) {
      left.push_back(p);
    }
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
                                     const std::vector<PlanLine>& traces,
                                     const std::vector<Plane>& planes) {
  std::vector<Direction> directions;
  const auto add = [&](const Eigen::Vector2d& normal, double bonus) {
    for (const Direction& known : directions) {
      const double sine = known.normal.x() * normal.y() - known.normal.y() * normal.x();
      if (std::abs(sine) < 0.5 * kSameAngle) return;
    }
    directions.push_back({normal, bonus, false});
  };
  for (const PlanLine& trace : traces) add(trace.normal, kOutlineBonus);
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

/// A stretch of points along a direction: within a band of offsets, without gaps.
struct Stretch {
  double score = 0.0;
  Points points;
};

/// The best stretch along a direction. Bands overlap by half, so that points within half a band of
/// each other share one.
Stretch best_stretch(const Points& points, const Direction& direction, double width, double gap) {
  struct Member {
    int64_t band;
    double along;
    size_t point;
  };
  const Eigen::Vector2d along(-direction.normal.y(), direction.normal.x());
  std::vector<Member> members;
  members.reserve(2 * points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const auto half =
        static_cast<int64_t>(std::floor(direction.normal.dot(points[i]) / (0.5 * width)));
    const double at = along.dot(points[i]);
    members.push_back({half, at, i});
    members.push_back({half - 1, at, i});
  }
  std::sort(members.begin(), members.end(), [](const Member& x, const Member& y) {
    return std::tie(x.band, x.along, x.point) < std::tie(y.band, y.along, y.point);
  });
  size_t best_first = 0, best_count = 0;
  for (size_t first = 0, i = 1; i <= members.size(); ++i) {
    if (i < members.size() && members[i].band == members[first].band &&
        members[i].along <= members[i - 1].along + gap) {
      continue;
    }
    if (i - first > best_count) {
      best_first = first;
      best_count = i - first;
    }
    first = i;
  }
  Stretch best;
  best.score = direction.bonus * static_cast<double>(best_count);
  for (size_t i = best_first; i < best_first + best_count; ++i) {
    best.points.push_back(points[members[i].point]);
  }
  return best;
}

/// The best stretch over all directions. Scores of `most` (per direction, those of before or
/// infinite) never rise as points go, so that most directions need no second look.
const Direction* best_direction(const Points& points, const std::vector<Direction>& directions,
                                double width, double gap, std::vector<double>* most,
                                Stretch* best) {
  const Direction* found = nullptr;
  *best = {};
  std::vector<size_t> order(directions.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t x, size_t y) { return (*most)[x] > (*most)[y]; });
  for (const size_t d : order) {
    if ((*most)[d] <= best->score) break;
    Stretch stretch = best_stretch(points, directions[d], width, gap);
    (*most)[d] = stretch.score;
    if (stretch.score <= best->score) continue;
    *best = std::move(stretch);
    found = &directions[d];
  }
  return found;
}

/// The stretch of a line that points lie along, and `beyond` on either side.
void cover(const Points& points, double beyond, PlanLine* line) {
  line->begin = std::numeric_limits<double>::infinity();
  line->end = -line->begin;
  for (const Eigen::Vector2d& p : points) {
    line->begin = std::min(line->begin, line->along(p) - beyond);
    line->end = std::max(line->end, line->along(p) + beyond);
  }
}

/// Makes a line's stretch take in that of another that runs along it.
void take_in(const PlanLine& other, PlanLine* line) {
  for (const double end : {other.begin, other.end}) {
    if (!std::isfinite(end)) {
      line->begin = -std::numeric_limits<double>::infinity();
      line->end = std::numeric_limits<double>::infinity();
      return;
    }
    line->begin = std::min(line->begin, line->along(other.at(end)));
    line->end = std::max(line->end, line->along(other.at(end)));
  }
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
      PlanLine line{normal, normal.dot(ring[i])};
      // As far as the next line beyond either corner.
      cover({ring[i], ring[(i + 1) % n]}, kBeyondCorner, &line);
      found.push_back({along.norm(), line});
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
                                      const std::vector<PlanLine>& traces,
                                      const ClosingOptions& options) {
  struct Crease {
    PlanLine line;
    size_t support;
  };
  std::vector<PlanLine> lines(
      traces.begin(),
      traces.begin() + std::min<std::ptrdiff_t>(options.max_lines, std::ssize(traces)));
  std::vector<Crease> creases;
  Points steps;
  for (auto& [pair, points] : borders_of(grid, labels)) {
    std::optional<PlanLine> crease = crease_of(planes, pair.first, pair.second);
    if (!crease) {
      steps.insert(steps.end(), points.begin(), points.end());
      continue;
    }
    const double slope = std::hypot(planes[pair.first].a - planes[pair.second].a,
                                    planes[pair.first].b - planes[pair.second].b);
    const double tolerance = 1.5 * grid.cell + std::min(1.0, kHeightTolerance / slope);
    Points left, on;
    for (const Eigen::Vector2d& p : points) {
      (std::abs(crease->signed_distance(p)) > tolerance ? left : on).push_back(p);
    }
    if (on.size() >= 2) {
      cover(on, 2.0 * grid.cell, &*crease);
      creases.push_back({*crease, on.size()});
    }
    steps.insert(steps.end(), left.begin(), left.end());
  }
  std::stable_sort(creases.begin(), creases.end(),
                   [](const Crease& x, const Crease& y) { return x.support > y.support; });
  for (const Crease& crease : creases) {
    if (static_cast<int>(lines.size()) == options.max_lines) return lines;
    lines.push_back(crease.line);
  }
  for (const PlanLine& line : lines) steps = away_from(line, grid.cell, steps);

  const std::vector<PlanLine> edges = edge_lines_of(outline, kLeastOutlineEdge);
  const std::vector<Direction> directions = directions_of(edges, traces, planes);
  std::vector<double> most(directions.size(), std::numeric_limits<double>::infinity());
  Stretch stretch;
  while (static_cast<int>(lines.size()) < options.max_lines) {
    const Direction* direction =
        best_direction(steps, directions, 2.0 * grid.cell, kGapCells * grid.cell, &most, &stretch);
    if (!direction) break;
    const Points& on = stretch.points;
    if (static_cast<double>(on.size()) * grid.cell < options.least_step_length) break;
    PlanLine line = line_through(on);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : on) mean += p / static_cast<double>(on.size());
    if (!direction->free) {
      line.normal = direction->normal;
      line.offset = line.normal.dot(mean);
    }
    for (const PlanLine& edge : edges) {
      if (!runs_along(line, edge, mean, options.snap_distance, 3.0 * kSameAngle)) continue;
      line = edge;
      break;
    }
    cover(on, grid.cell, &line);
    const size_t before = steps.size();
    steps = away_from(line, grid.cell, steps);
    // A line moved to an edge may be beside its points.
    std::erase_if(steps, [&](const Eigen::Vector2d& p) {
      return std::find(on.begin(), on.end(), p) != on.end();
    });
    if (steps.size() == before) break;
    const auto known = std::find_if(lines.begin(), lines.end(), [&](const PlanLine& other) {
      return runs_along(line, other, mean, options.snap_distance, kSameAngle);
    });
    if (known == lines.end()) {
      lines.push_back(line);
    } else {
      take_in(line, &*known);
    }
  }
  for (const PlanLine& line : reentrant_lines(outline)) {
    if (static_cast<int>(lines.size()) >= options.max_lines) break;
    const auto same = [&](const PlanLine& other) {
      return runs_along(line, other, line.at(0.5 * (line.begin + line.end)), kSameReentrant,
                        kSameAngle);
    };
    const auto known = std::find_if(lines.begin(), lines.end(), same);
    if (known == lines.end()) {
      lines.push_back(line);
    } else {
      take_in(line, &*known);
    }
  }
  return lines;
}

}  // namespace gable
