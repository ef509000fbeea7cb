#include <gable/grammar/solid/plan_bodies.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gable {
namespace {

constexpr double kSameHeight = 2e-4;

// Vertical planes, told apart by where they stand and which side they face.
class WallPlanes {
 public:
  // Number of the plane through two points of the plan that faces right of from -> to.
  int number_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    Eigen::Vector2d normal(to.y() - from.y(), from.x() - to.x());
    normal.normalize();
    // Most walls run along the house's axes; a short one must still name its long line exactly.
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(normal[axis]) < 1e-2 && std::abs(from[1 - axis] - to[1 - axis]) < 1e-4) {
        normal[axis] = 0.0;
        normal[1 - axis] = normal[1 - axis] > 0.0 ? 1.0 : -1.0;
      }
    }
    const auto near = [](double distance) { return std::abs(distance) < 1e-4; };
    for (size_t i = 0; i < walls_.size(); ++i) {
      if (normal.dot(walls_[i].normal) > 0.999 &&
          near(walls_[i].normal.dot(from) - walls_[i].offset) &&
          near(walls_[i].normal.dot(to) - walls_[i].offset)) {
        return static_cast<int>(i);
      }
    }
    walls_.push_back({normal, 0.5 * normal.dot(from + to)});
    return static_cast<int>(walls_.size()) - 1;
  }

 private:
  struct Wall {
    Eigen::Vector2d normal;
    double offset;
  };
  std::vector<Wall> walls_;
};

class BodyRaiser {
 public:
  BodyRaiser(const PlanGraph& graph, const std::vector<Plane>& planes,
             const std::vector<int>& body_of_cell, int body)
      : graph_(graph),
        planes_(planes),
        body_of_cell_(body_of_cell),
        body_(body),
        levels_(graph.vertices.size()) {}

  SurfaceMesh raise() {
    for (size_t c = 0; c < graph_.cells.size(); ++c) {
      if (body_of_cell_[c] == body_) add_cell(graph_.cells[c]);
    }
    const size_t first_wall = mesh_.pieces.size();
    for (const PlanEdge& edge : graph_.edges) add_walls(edge);
    // A vertical side must stop at every vertex on it, also at those of walls added later.
    for (size_t i = first_wall; i < mesh_.pieces.size(); ++i) {
      std::vector<int>& ring = mesh_.pieces[i].rings[0];
      ring = with_levels_between(ring);
    }
    return std::move(mesh_);
  }

 private:
  int vertex(int plan_vertex, int plane) {
    const Eigen::Vector2d& p = graph_.vertices[plan_vertex];
    const double z = planes_[plane].at(p);
    for (const int v : levels_[plan_vertex]) {
      if (std::abs(mesh_.vertices[v].z() - z) < kSameHeight) return v;
    }
    levels_[plan_vertex].push_back(static_cast<int>(mesh_.vertices.size()));
    mesh_.vertices.emplace_back(p.x(), p.y(), z);
    plan_vertex_.push_back(plan_vertex);
    return levels_[plan_vertex].back();
  }

  void add_cell(const PlanCell& cell) {
    SurfacePiece upper, lower;
    upper.type = SurfaceType::kRoof;
    upper.surface = cell.label.upper;
    lower.type = SurfaceType::kGround;
    lower.surface = cell.label.lower;
    for (const std::vector<int>& ring : cell.rings) {
      std::vector<int>& upper_ring = upper.rings.emplace_back();
      std::vector<int>& lower_ring = lower.rings.emplace_back();
      for (const int v : ring) {
        upper_ring.push_back(vertex(v, cell.label.upper));
        lower_ring.push_back(vertex(v, cell.label.lower));
      }
      std::reverse(lower_ring.begin(), lower_ring.end());
    }
    mesh_.pieces.push_back(std::move(upper));
    mesh_.pieces.push_back(std::move(lower));
  }

  CellLabel label_in_body(int cell) const {
    return cell >= 0 && body_of_cell_[cell] == body_ ? graph_.cells[cell].label : CellLabel{};
  }

  void add_walls(const PlanEdge& edge) {
    const CellLabel left = label_in_body(edge.left_cell);
    const CellLabel right = label_in_body(edge.right_cell);
    add_walls_of(edge.from, edge.to, left, right);
    add_walls_of(edge.to, edge.from, right, left);
  }

  // Walls of the cell left of from -> to, where the cell on the right does not stand against it.
  void add_walls_of(int from, int to, const CellLabel& own, const CellLabel& other) {
    if (own.empty()) return;
    const Eigen::Vector2d middle = 0.5 * (graph_.vertices[from] + graph_.vertices[to]);
    const auto height = [&](int plane) { return planes_[plane].at(middle); };
    // No two planes cross inside an edge: what holds in its middle holds all along.
    if (other.empty() || height(own.upper) <= height(other.lower) ||
        height(own.lower) >= height(other.upper)) {
      add_wall(from, to, own.lower, own.upper);
      return;
    }
    if (height(other.lower) > height(own.lower)) add_wall(from, to, own.lower, other.lower);
    if (height(own.upper) > height(other.upper)) add_wall(from, to, other.upper, own.upper);
  }

  void add_wall(int from, int to, int lower, int upper) {
    if (lower == upper) return;
    std::vector<int> ring;
    for (const int v :
         {vertex(from, lower), vertex(to, lower), vertex(to, upper), vertex(from, upper)}) {
      if (ring.empty() || (ring.back() != v && ring.front() != v)) ring.push_back(v);
    }
    if (ring.size() < 3) return;
    SurfacePiece wall;
    wall.type = SurfaceType::kWall;
    wall.surface = walls_.number_of(graph_.vertices[from], graph_.vertices[to]);
    wall.rings.push_back(std::move(ring));
    mesh_.pieces.push_back(std::move(wall));
  }

  std::vector<int> with_levels_between(const std::vector<int>& ring) const {
    std::vector<int> full;
    for (size_t i = 0; i < ring.size(); ++i) {
      const int v = ring[i], w = ring[(i + 1) % ring.size()];
      full.push_back(v);
      if (plan_vertex_[v] != plan_vertex_[w]) continue;
      const double from = mesh_.vertices[v].z(), to = mesh_.vertices[w].z();
      const size_t begin = full.size();
      for (const int between : levels_[plan_vertex_[v]]) {
        const double z = mesh_.vertices[between].z();
        if ((z - from) * (z - to) < 0.0) full.push_back(between);
      }
      std::sort(full.begin() + static_cast<std::ptrdiff_t>(begin), full.end(), [&](int a, int b) {
        return std::abs(mesh_.vertices[a].z() - from) < std::abs(mesh_.vertices[b].z() - from);
      });
    }
    return full;
  }

  const PlanGraph& graph_;
  const std::vector<Plane>& planes_;
  const std::vector<int>& body_of_cell_;
  const int body_;
  SurfaceMesh mesh_;
  std::vector<std::vector<int>> levels_;  // by plan vertex: mesh vertices above it
  std::vector<int> plan_vertex_;          // by mesh vertex
  WallPlanes walls_;
};

// Numbers the bodies; cells that share a vertical section belong together.
std::vector<int> number_bodies(const PlanGraph& graph, const std::vector<Plane>& planes,
                               int* num_bodies) {
  std::vector<int> group(graph.cells.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&group](int i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const PlanEdge& edge : graph.edges) {
    if (edge.left_cell < 0 || edge.right_cell < 0) continue;
    const Eigen::Vector2d middle = 0.5 * (graph.vertices[edge.from] + graph.vertices[edge.to]);
    const auto height = [&](int plane) { return planes[plane].at(middle); };
    const double top = std::min(height(edge.left.upper), height(edge.right.upper));
    const double bottom = std::max(height(edge.left.lower), height(edge.right.lower));
    if (top - bottom < kSameHeight) continue;
    const auto [first, second] = std::minmax({root(edge.left_cell), root(edge.right_cell)});
    group[second] = first;
  }
  std::vector<int> body(group.size(), -1);
  *num_bodies = 0;
  for (size_t c = 0; c < group.size(); ++c) {
    const int r = root(static_cast<int>(c));
    if (r == static_cast<int>(c)) body[c] = (*num_bodies)++;
    body[c] = body[r];
  }
  return body;
}

}  // namespace

std::vector<SurfaceMesh> raise_bodies(const PlanGraph& graph, const std::vector<Plane>& planes) {
  int num_bodies = 0;
  const std::vector<int> body_of_cell = number_bodies(graph, planes, &num_bodies);
  std::vector<SurfaceMesh> bodies;
  for (int body = 0; body < num_bodies; ++body) {
    bodies.push_back(BodyRaiser(graph, planes, body_of_cell, body).raise());
  }
  return bodies;
}

}  // namespace gable
