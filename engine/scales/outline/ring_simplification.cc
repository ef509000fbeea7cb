#include <gable/engine/scales/outline/ring_simplification.h>

#include <algorithm>
#include <utility>

namespace gable {
namespace {

constexpr int kHalvings = 4;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Douglas and Peucker between two fixed corners, which may be the same.
void mark_kept(const Ring& ring, size_t first, size_t last, double tolerance,
               std::vector<char>& kept) {
  std::vector<std::pair<size_t, size_t>> spans{{first, last}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double farthest = tolerance;
    size_t corner = from;
    for (size_t i = from + 1; i < to; ++i) {
      const double d = distance_to_segment(ring[i], ring[from], ring[to % ring.size()]);
      if (d > farthest) {
        farthest = d;
        corner = i;
      }
    }
    if (corner == from) continue;
    kept[corner] = 1;
    spans.emplace_back(from, corner);
    spans.emplace_back(corner, to);
  }
}

Ring simplified_ring(const Ring& ring, double tolerance) {
  // Two corners that are certainly corners: the first in lexicographic order and the one farthest
  // from it.
  const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  Ring turned = ring;
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end(), less), turned.end());
  const auto farther = [&turned](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - turned[0]).squaredNorm() < (b - turned[0]).squaredNorm();
  };
  const size_t opposite = std::max_element(turned.begin(), turned.end(), farther) - turned.begin();
  std::vector<char> kept(turned.size(), 0);
  kept[0] = kept[opposite] = 1;
  mark_kept(turned, 0, opposite, tolerance, kept);
  mark_kept(turned, opposite, turned.size(), tolerance, kept);
  Ring out;
  for (size_t i = 0; i < turned.size(); ++i) {
    if (kept[i]) out.push_back(turned[i]);
  }
  return out;
}

struct Edge {
  Eigen::Vector2d a, b;
  size_t ring, place;
  double min_x() const { return std::min(a.x(), b.x()); }
  double max_x() const { return std::max(a.x(), b.x()); }
};

bool in_box(const Eigen::Vector2d& p, const Edge& e) {
  return p.x() >= e.min_x() && p.x() <= e.max_x() && p.y() >= std::min(e.a.y(), e.b.y()) &&
         p.y() <= std::max(e.a.y(), e.b.y());
}

bool meet(const Edge& e, const Edge& f) {
  const double fa = cross(e.b - e.a, f.a - e.a), fb = cross(e.b - e.a, f.b - e.a);
  const double ea = cross(f.b - f.a, e.a - f.a), eb = cross(f.b - f.a, e.b - f.a);
  if (((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) && ((ea > 0 && eb < 0) || (ea < 0 && eb > 0))) {
    return true;
  }
  return (fa == 0 && in_box(f.a, e)) || (fb == 0 && in_box(f.b, e)) ||
         (ea == 0 && in_box(e.a, f)) || (eb == 0 && in_box(e.b, f));
}

/// Neighbours share one corner; they meet elsewhere only where the second turns back on the first.
bool turn_back(const Edge& first, const Edge& second) {
  const Eigen::Vector2d u = first.b - first.a, v = second.b - second.a;
  return cross(u, v) == 0 && u.dot(v) <= 0;
}

}  // namespace

bool are_simple(const std::vector<Ring>& rings) {
  std::vector<Edge> edges;
  for (size_t r = 0; r < rings.size(); ++r) {
    for (size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({rings[r][i], rings[r][(i + 1) % rings[r].size()], r, i});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.min_x() < f.min_x(); });
  for (size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    const double low = std::min(e.a.y(), e.b.y()), high = std::max(e.a.y(), e.b.y());
    for (size_t j = i + 1; j < edges.size() && edges[j].min_x() <= e.max_x(); ++j) {
      const Edge& f = edges[j];
      if (std::max(f.a.y(), f.b.y()) < low || std::min(f.a.y(), f.b.y()) > high) continue;
      const size_t n = rings[e.ring].size();
      if (e.ring == f.ring && (e.place + 1) % n == f.place) {
        if (turn_back(e, f)) return false;
      } else if (e.ring == f.ring && (f.place + 1) % n == e.place) {
        if (turn_back(f, e)) return false;
      } else if (meet(e, f)) {
        return false;
      }
    }
  }
  return true;
}

std::vector<Ring> simplified(const std::vector<Ring>& rings, double tolerance) {
  const auto by = [&rings](double t) {
    std::vector<Ring> out;
    for (const Ring& ring : rings) {
      if (ring.size() < 3) continue;
      Ring simple = t > 0.0 ? simplified_ring(ring, t) : ring;
      if (simple.size() >= 3 && signed_area(simple) != 0.0) out.push_back(std::move(simple));
    }
    return out;
  };
  for (int i = 0; i < kHalvings; ++i) {
    std::vector<Ring> out = by(tolerance);
    if (are_simple(out)) return out;
    tolerance /= 2.0;
  }
  return by(0.0);
}

}  // namespace gable
