#include <gable/grammar/ring.h>
#include <gable/grammar/solid/plan_cells.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gable {
namespace {

// Half-edge 2e runs along edge e, half-edge 2e + 1 against it; each has its cell on the left.
class HalfEdges {
 public:
  explicit HalfEdges(const PlanGraph& graph) : graph_(graph), outgoing_(graph.vertices.size()) {
    const int n = count();
    for (int h = 0; h < n; ++h) outgoing_[start(h)].push_back(h);
    place_.resize(n);
    for (std::vector<int>& out : outgoing_) {
      std::vector<std::pair<double, int>> by_angle;
      for (const int h : out) {
        const Eigen::Vector2d d = graph_.vertices[end(h)] - graph_.vertices[start(h)];
        by_angle.emplace_back(std::atan2(d.y(), d.x()), h);
      }
      std::sort(by_angle.begin(), by_angle.end());
      for (size_t i = 0; i < out.size(); ++i) {
        out[i] = by_angle[i].second;
        place_[out[i]] = static_cast<int>(i);
      }
    }
  }

  int count() const { return 2 * static_cast<int>(graph_.edges.size()); }
  int start(int h) const { return h % 2 ? graph_.edges[h / 2].to : graph_.edges[h / 2].from; }
  int end(int h) const { return start(h ^ 1); }
  const CellLabel& label(int h) const {
    return h % 2 ? graph_.edges[h / 2].right : graph_.edges[h / 2].left;
  }
  // The next half-edge round the cell on the left: the first one clockwise from the way back.
  int next(int h) const {
    const std::vector<int>& out = outgoing_[end(h)];
    const size_t back = place_[h ^ 1];
    return out[(back + out.size() - 1) % out.size()];
  }

 private:
  const PlanGraph& graph_;
  std::vector<std::vector<int>> outgoing_;
  std::vector<int> place_;
};

using Loop = std::vector<int>;  // half-edges

// Cuts a closed walk into loops that pass each vertex once.
void append_simple_loops(const HalfEdges& half_edges, const Loop& walk, std::vector<Loop>* loops) {
  Loop open;
  for (const int h : walk) {
    open.push_back(h);
    const int vertex = half_edges.end(h);
    for (size_t i = open.size(); i-- > 0;) {
      if (half_edges.start(open[i]) != vertex) continue;
      loops->emplace_back(open.begin() + static_cast<std::ptrdiff_t>(i), open.end());
      open.resize(i);
      break;
    }
  }
}

std::vector<int> ring_of(const HalfEdges& half_edges, const Loop& loop) {
  std::vector<int> ring;
  for (const int h : loop) ring.push_back(half_edges.start(h));
  return ring;
}

std::vector<Eigen::Vector2d> points_of(const PlanGraph& graph, const std::vector<int>& ring) {
  std::vector<Eigen::Vector2d> points;
  for (const int v : ring) points.push_back(graph.vertices[v]);
  return points;
}

void set_cell(const Loop& loop, int cell, PlanGraph* graph) {
  for (const int h : loop) {
    PlanEdge& edge = graph->edges[h / 2];
    (h % 2 ? edge.right_cell : edge.left_cell) = cell;
  }
}

// The smallest cell of the hole's label whose outer ring goes round it, or -1.
int cell_round(const PlanGraph& graph, const CellLabel& label, const std::vector<int>& hole) {
  int best = -1;
  double best_area = std::numeric_limits<double>::infinity();
  for (size_t c = 0; c < graph.cells.size(); ++c) {
    if (graph.cells[c].label != label) continue;
    const std::vector<int>& outer = graph.cells[c].rings[0];
    const auto apart = std::find_if(hole.begin(), hole.end(), [&outer](int v) {
      return std::find(outer.begin(), outer.end(), v) == outer.end();
    });
    const std::vector<Eigen::Vector2d> points = points_of(graph, outer);
    const double area = signed_area(points);
    if (apart == hole.end() || area >= best_area) continue;
    if (!ring_holds(points, graph.vertices[*apart])) continue;
    best = static_cast<int>(c);
    best_area = area;
  }
  return best;
}

}  // namespace

bool trace_cells(PlanGraph* graph) {
  const HalfEdges half_edges(*graph);
  std::vector<bool> seen(half_edges.count(), false);
  std::vector<Loop> holes;
  for (int first = 0; first < half_edges.count(); ++first) {
    if (seen[first]) continue;
    Loop walk;
    for (int h = first; !seen[h]; h = half_edges.next(h)) {
      seen[h] = true;
      walk.push_back(h);
      if (half_edges.label(h) != half_edges.label(first)) return false;
    }
    if (half_edges.label(first).empty()) continue;
    std::vector<Loop> loops;
    append_simple_loops(half_edges, walk, &loops);
    for (const Loop& loop : loops) {
      std::vector<int> ring = ring_of(half_edges, loop);
      if (signed_area(points_of(*graph, ring)) < 0.0) {
        holes.push_back(loop);
        continue;
      }
      set_cell(loop, static_cast<int>(graph->cells.size()), graph);
      graph->cells.push_back({half_edges.label(first), {std::move(ring)}});
    }
  }
  for (const Loop& hole : holes) {
    std::vector<int> ring = ring_of(half_edges, hole);
    const int cell = cell_round(*graph, half_edges.label(hole[0]), ring);
    if (cell < 0) return false;
    set_cell(hole, cell, graph);
    graph->cells[cell].rings.push_back(std::move(ring));
  }
  return true;
}

}  // namespace gable
