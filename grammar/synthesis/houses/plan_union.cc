#include <gable/grammar/synthesis/houses/plan_union.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace gable {
namespace {

constexpr double kFlatCorner = 0.005;  // corners that stand out less are dropped, metres
constexpr double kLeastHole = 0.1;     // smaller holes are gaps between parts, metres squared

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A ring in general position to all others.
Ring disturbed(const Ring& ring, size_t number) {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (const auto& p : ring) center += p / static_cast<double>(ring.size());
  // Multiples of the golden ratio are spread evenly and never repeat.
  const double any = std::fmod(0.6180339887498949 * static_cast<double>(number + 1), 1.0);
  const double grow = 0.001 + 0.003 * any;
  const double turn = 1e-5 * (any - 0.5);
  Ring result;
  for (const auto& p : ring) {
    const Eigen::Vector2d d = p - center;
    const Eigen::Vector2d turned = d + turn * Eigen::Vector2d(-d.y(), d.x());
    result.push_back(center + turned * (1.0 + 1.5 * grow / std::max(d.norm(), 0.1)));
  }
  return result;
}

/// Strictly inside a convex ring that runs anticlockwise.
bool inside_convex(const Ring& ring, const Eigen::Vector2d& p) {
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d& a = ring[k];
    const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
    if (cross(b - a, p - a) <= 0.0) return false;
  }
  return true;
}

/// All rings' edges, each with the nodes that lie on it.
struct Edges {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<size_t> ring;                                  // of each edge
  std::vector<std::pair<size_t, size_t>> ends;               // nodes
  std::vector<std::vector<std::pair<double, size_t>>> cuts;  // (share of the way, node)

  explicit Edges(const std::vector<Ring>& rings) {
    for (size_t r = 0; r < rings.size(); ++r) {
      const size_t first = nodes.size();
      for (size_t k = 0; k < rings[r].size(); ++k) {
        nodes.push_back(rings[r][k]);
        ring.push_back(r);
        ends.emplace_back(first + k, first + (k + 1) % rings[r].size());
      }
    }
    cuts.resize(ends.size());
    for (size_t i = 0; i < ends.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        if (ring[i] != ring[j]) cut(i, j);
      }
    }
  }

  void cut(size_t i, size_t j) {
    const Eigen::Vector2d a = nodes[ends[i].first], c = nodes[ends[j].first];
    const Eigen::Vector2d ab = nodes[ends[i].second] - a, cd = nodes[ends[j].second] - c;
    const double area = cross(ab, cd);
    if (area == 0.0) return;
    const double on_i = cross(c - a, cd) / area;
    const double on_j = cross(c - a, ab) / area;
    if (on_i <= 0.0 || on_i >= 1.0 || on_j <= 0.0 || on_j >= 1.0) return;
    cuts[i].emplace_back(on_i, nodes.size());
    cuts[j].emplace_back(on_j, nodes.size());
    nodes.push_back(a + on_i * ab);
  }
};

/// From each node on the boundary of the union to the next, anticlockwise around the inside.
std::map<size_t, size_t> boundary(const std::vector<Ring>& rings, Edges* edges) {
  std::map<size_t, size_t> next;
  for (size_t e = 0; e < edges->ends.size(); ++e) {
    auto& cuts = edges->cuts[e];
    std::sort(cuts.begin(), cuts.end());
    size_t from = edges->ends[e].first;
    for (size_t k = 0; k <= cuts.size(); ++k) {
      const size_t to = k < cuts.size() ? cuts[k].second : edges->ends[e].second;
      const Eigen::Vector2d middle = 0.5 * (edges->nodes[from] + edges->nodes[to]);
      bool outside = true;
      for (size_t r = 0; r < rings.size() && outside; ++r) {
        outside = r == edges->ring[e] || !inside_convex(rings[r], middle);
      }
      if (outside) next[from] = to;
      from = to;
    }
  }
  return next;
}

Ring without_flat_corners(const Ring& ring) {
  Ring corners;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d& before = corners.empty() ? ring.back() : corners.back();
    const Eigen::Vector2d along = ring[(k + 1) % ring.size()] - before;
    const double off = std::abs(cross(along, ring[k] - before)) / std::max(along.norm(), 1e-9);
    if (off > kFlatCorner) corners.push_back(ring[k]);
  }
  return corners;
}

double segment_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

bool cross_each_other(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d) {
  return (cross(b - a, c - a) > 0.0) != (cross(b - a, d - a) > 0.0) &&
         (cross(d - c, a - c) > 0.0) != (cross(d - c, b - c) > 0.0);
}

}  // namespace

double ring_distance(const Ring& a, const Ring& b) {
  if (ring_holds(a, b.front()) || ring_holds(b, a.front())) return 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d& a0 = a[i];
    const Eigen::Vector2d& a1 = a[(i + 1) % a.size()];
    for (size_t j = 0; j < b.size(); ++j) {
      const Eigen::Vector2d& b0 = b[j];
      const Eigen::Vector2d& b1 = b[(j + 1) % b.size()];
      if (cross_each_other(a0, a1, b0, b1)) return 0.0;
      nearest = std::min({nearest, segment_distance(a0, b0, b1), segment_distance(b0, a0, a1)});
    }
  }
  return nearest;
}

PlanPolygon union_of_convex(const std::vector<Ring>& rings) {
  std::vector<Ring> apart;
  for (size_t r = 0; r < rings.size(); ++r) apart.push_back(disturbed(rings[r], r));
  Edges edges(apart);
  std::map<size_t, size_t> next = boundary(apart, &edges);
  PlanPolygon polygon;
  std::vector<Ring> holes;
  double largest = 0.0;
  while (!next.empty()) {
    Ring ring;
    for (auto it = next.begin(); it != next.end();) {
      const size_t to = it->second;
      ring.push_back(edges.nodes[it->first]);
      next.erase(it);
      it = next.find(to);
    }
    const double area = signed_area(ring);
    if (area < -kLeastHole) holes.push_back(without_flat_corners(ring));
    if (area <= largest) continue;
    largest = area;
    polygon.outer = without_flat_corners(ring);
  }
  for (Ring& hole : holes) {
    if (ring_holds(polygon.outer, hole.front())) polygon.holes.push_back(std::move(hole));
  }
  return polygon;
}

}  // namespace gable
