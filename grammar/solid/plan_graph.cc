#include <gable/grammar/solid/plan_cells.h>
#include <gable/grammar/solid/plan_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace gable {
namespace {

constexpr double kSamePoint = 2e-6;
constexpr double kOnSegment = 5e-6;   // more than a point moves when it is merged
constexpr double kBeside = 2e-5;      // where labels are read: well clear of kOnSegment
constexpr double kSameHeight = 1e-4;  // heights that count as touching at the end of an edge

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool same_segment(const PlanSegment& s, const PlanSegment& t) {
  const auto near = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return (p - q).lpNorm<Eigen::Infinity>() < 1e-9;
  };
  return (near(s.from, t.from) && near(s.to, t.to)) || (near(s.from, t.to) && near(s.to, t.from));
}

std::vector<PlanSegment> distinct_segments(const std::vector<PlanSegment>& segments) {
  std::vector<PlanSegment> distinct;
  for (const PlanSegment& s : segments) {
    if ((s.to - s.from).norm() < kSamePoint) continue;
    const auto same = [&s](const PlanSegment& t) { return same_segment(s, t); };
    if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(s);
  }
  return distinct;
}

void append_crossing(const PlanSegment& s, const PlanSegment& t,
                     std::vector<Eigen::Vector2d>* points) {
  for (int axis = 0; axis < 2; ++axis) {
    const auto [s_low, s_high] = std::minmax(s.from[axis], s.to[axis]);
    const auto [t_low, t_high] = std::minmax(t.from[axis], t.to[axis]);
    if (s_high < t_low - kSamePoint || t_high < s_low - kSamePoint) return;
  }
  const Eigen::Vector2d ds = s.to - s.from, dt = t.to - t.from;
  const double denominator = cross(ds, dt);
  if (std::abs(denominator) < 1e-10 * ds.norm() * dt.norm()) return;
  const double at_s = cross(t.from - s.from, dt) / denominator;
  const double at_t = cross(t.from - s.from, ds) / denominator;
  if (at_s <= 0.0 || at_s >= 1.0 || at_t <= 0.0 || at_t >= 1.0) return;
  points->push_back(s.from + ds * at_s);
}

// Merges points that lie together; of each group the earliest stays.
std::vector<Eigen::Vector2d> distinct_points(const std::vector<Eigen::Vector2d>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&points](int i, int j) {
    return points[i].x() < points[j].x() || (points[i].x() == points[j].x() && i < j);
  });
  std::vector<int> group(points.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&group](int i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (size_t i = 0; i < order.size(); ++i) {
    for (size_t j = i + 1; j < order.size(); ++j) {
      if (points[order[j]].x() - points[order[i]].x() > kSamePoint) break;
      if (std::abs(points[order[j]].y() - points[order[i]].y()) > kSamePoint) continue;
      const auto [first, second] = std::minmax({root(order[i]), root(order[j])});
      group[second] = first;
    }
  }
  std::vector<Eigen::Vector2d> distinct;
  for (size_t i = 0; i < points.size(); ++i) {
    if (root(static_cast<int>(i)) == static_cast<int>(i)) distinct.push_back(points[i]);
  }
  return distinct;
}

// The pairs of consecutive vertices along all segments, each once, first index smaller.
std::vector<std::pair<int, int>> cut_at_vertices(const std::vector<PlanSegment>& segments,
                                                 const std::vector<Eigen::Vector2d>& vertices) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<std::pair<double, int>> on;
  for (const PlanSegment& s : segments) {
    const Eigen::Vector2d d = s.to - s.from;
    const double length = d.norm();
    on.clear();
    for (size_t v = 0; v < vertices.size(); ++v) {
      const Eigen::Vector2d from_start = vertices[v] - s.from;
      if (std::abs(cross(d, from_start)) > kOnSegment * length) continue;
      const double along = d.dot(from_start) / length;
      if (along < -kOnSegment || along > length + kOnSegment) continue;
      on.emplace_back(along, static_cast<int>(v));
    }
    std::sort(on.begin(), on.end());
    for (size_t i = 0; i + 1 < on.size(); ++i) {
      pairs.push_back(std::minmax(on[i].second, on[i + 1].second));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Cuts an edge where two of the planes beside it cross.
void append_edge(const PlanEdge& edge, const std::vector<Plane>& planes, PlanGraph* graph) {
  const Eigen::Vector2d from = graph->vertices[edge.from], to = graph->vertices[edge.to];
  const std::array<int, 4> beside = {edge.left.upper, edge.left.lower, edge.right.upper,
                                     edge.right.lower};
  std::vector<double> cuts;
  for (size_t i = 0; i < beside.size(); ++i) {
    for (size_t j = i + 1; j < beside.size(); ++j) {
      if (beside[i] < 0 || beside[j] < 0 || beside[i] == beside[j]) continue;
      const double at_from = planes[beside[i]].at(from) - planes[beside[j]].at(from);
      const double at_to = planes[beside[i]].at(to) - planes[beside[j]].at(to);
      if (std::min(std::abs(at_from), std::abs(at_to)) < kSameHeight) continue;
      if ((at_from > 0.0) != (at_to > 0.0)) cuts.push_back(at_from / (at_from - at_to));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  PlanEdge piece = edge;
  const double length = (to - from).norm();
  double last = 0.0;
  for (const double cut : cuts) {
    if ((cut - last) * length < kSamePoint || (1.0 - cut) * length < kSamePoint) continue;
    last = cut;
    piece.to = static_cast<int>(graph->vertices.size());
    graph->vertices.push_back(from + (to - from) * cut);
    graph->edges.push_back(piece);
    piece.from = piece.to;
  }
  piece.to = edge.to;
  graph->edges.push_back(piece);
}

}  // namespace

void append_ring(const Ring& ring, std::vector<PlanSegment>* segments) {
  for (size_t i = 0; i < ring.size(); ++i) {
    segments->push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
}

void append_rings(std::span<const Ring> rings, std::vector<PlanSegment>* segments) {
  for (const Ring& ring : rings) append_ring(ring, segments);
}

std::optional<PlanGraph> divide_plan(const std::vector<PlanSegment>& segments,
                                     const LabelFunction& label, const std::vector<Plane>& planes) {
  const std::vector<PlanSegment> lines = distinct_segments(segments);
  std::vector<Eigen::Vector2d> points;
  for (const PlanSegment& s : lines) {
    points.push_back(s.from);
    points.push_back(s.to);
  }
  for (size_t i = 0; i < lines.size(); ++i) {
    for (size_t j = i + 1; j < lines.size(); ++j) append_crossing(lines[i], lines[j], &points);
  }
  PlanGraph graph;
  graph.vertices = distinct_points(points);
  for (const auto& [from, to] : cut_at_vertices(lines, graph.vertices)) {
    const Eigen::Vector2d p = graph.vertices[from], q = graph.vertices[to];
    const Eigen::Vector2d along = (q - p).normalized();
    const Eigen::Vector2d aside = kBeside * Eigen::Vector2d(-along.y(), along.x());
    PlanEdge edge{from, to, label(0.5 * (p + q) + aside), label(0.5 * (p + q) - aside)};
    if (edge.left != edge.right) append_edge(edge, planes, &graph);
  }
  if (!trace_cells(&graph)) return std::nullopt;
  return graph;
}

}  // namespace gable
