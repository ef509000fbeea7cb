#include <gable/engine/reconstruct/scan/traced_outline.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/ring.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastSeen = 0.5;   // of an edge, along its trace
constexpr double kFarthest = 3.0;    // that corners move, in distances of edges to traces
constexpr double kLeastSine = 0.2;   // of edges that cross at a corner
constexpr double kLeastEdge = 1e-3;  // metres
constexpr double kLeastArea = 0.25;  // of a ring that is kept, of its area before

/// The line of an edge, and the number of its trace, or -1.
struct EdgeLine {
  PlanLine line;
  int trace = -1;
};

EdgeLine line_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                 const std::vector<PlanLine>& traces, double distance) {
  const Eigen::Vector2d along = to - from;
  const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
  EdgeLine edge{{normal, 0.5 * normal.dot(from + to)}, -1};
  double nearest = distance;
  for (size_t i = 0; i < traces.size(); ++i) {
    const PlanLine& trace = traces[i];
    const double off =
        std::max(std::abs(trace.signed_distance(from)), std::abs(trace.signed_distance(to)));
    if (off > nearest) continue;
    const auto [low, high] = std::minmax({trace.along(from), trace.along(to)});
    const double seen = std::min(high, trace.end) - std::max(low, trace.begin);
    if (high - low < 0.5 * along.norm() || seen < kLeastSeen * (high - low)) continue;
    nearest = off;
    edge = {trace, static_cast<int>(i)};
  }
  return edge;
}

std::optional<Eigen::Vector2d> crossing_of(const PlanLine& a, const PlanLine& b) {
  const double sine = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
  if (std::abs(sine) < kLeastSine) return std::nullopt;
  return Eigen::Vector2d((a.offset * b.normal.y() - b.offset * a.normal.y()) / sine,
                         (b.offset * a.normal.x() - a.offset * b.normal.x()) / sine);
}

Eigen::Vector2d foot_on(const PlanLine& line, const Eigen::Vector2d& p) {
  return p - line.signed_distance(p) * line.normal;
}

Ring traced_ring(const Ring& ring, const std::vector<PlanLine>& traces, double distance) {
  const size_t n = ring.size();
  std::vector<EdgeLine> edges;
  for (size_t i = 0; i < n; ++i) {
    edges.push_back(line_of(ring[i], ring[(i + 1) % n], traces, distance));
  }
  Ring traced;
  for (size_t i = 0; i < n; ++i) {
    const EdgeLine &before = edges[(i + n - 1) % n], &after = edges[i];
    if (before.trace < 0 && after.trace < 0) {
      traced.push_back(ring[i]);
      continue;
    }
    if (before.trace == after.trace) continue;
    const std::optional<Eigen::Vector2d> crossing = crossing_of(before.line, after.line);
    if (crossing && (*crossing - ring[i]).norm() <= kFarthest * distance) {
      traced.push_back(*crossing);
      continue;
    }
    for (const EdgeLine& edge : {before, after}) {
      const Eigen::Vector2d foot = foot_on(edge.line, ring[i]);
      if (traced.empty() || (foot - traced.back()).norm() > kLeastEdge) traced.push_back(foot);
    }
  }
  return traced;
}

}  // namespace

PlanPolygon traced_outline(const PlanPolygon& outline, const std::vector<PlanLine>& traces,
                           double distance) {
  std::vector<Ring> rings = {outline.outer};
  rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
  for (Ring& ring : rings) {
    Ring traced = traced_ring(ring, traces, distance);
    if (traced.size() < 3) continue;
    if (std::abs(signed_area(traced)) < kLeastArea * std::abs(signed_area(ring))) continue;
    std::swap(ring, traced);
    if (!are_simple(rings)) std::swap(ring, traced);
  }
  PlanPolygon result{std::move(rings.front()), {}};
  for (size_t i = 1; i < rings.size(); ++i) result.holes.push_back(std::move(rings[i]));
  return result;
}

}  // namespace gable
