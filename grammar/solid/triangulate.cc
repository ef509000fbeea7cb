#include <gable/grammar/solid/triangulate.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// A corner of the polygon being clipped: its vertex, and where that lies in the face's plane.
struct Corner {
  int vertex;
  Eigen::Vector2d at;
};
using Ring = std::vector<Corner>;

/// Twice the signed area of a triangle.
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Normal of the outer ring by Newell's sum; its length is twice the area.
Eigen::Vector3d newell(const Solid& solid, const std::vector<int>& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Eigen::Vector3d& origin = solid.vertices[ring[0]];
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector3d a = solid.vertices[ring[i]] - origin;
    const Eigen::Vector3d b = solid.vertices[ring[(i + 1) % ring.size()]] - origin;
    sum += a.cross(b);
  }
  return sum;
}

/// Whether the segments a-b and c-d share a point that is inside either, or lie on each other.
bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  if (a == c || a == d || b == c || b == d) {
    // Joined at an end: they only meet further on when they run on top of each other.
    const Eigen::Vector2d& joint = a == c || a == d ? a : b;
    const Eigen::Vector2d u = (joint == a ? b : a) - joint;
    const Eigen::Vector2d v = (joint == c ? d : c) - joint;
    return u.x() * v.y() == u.y() * v.x() && u.dot(v) > 0.0;
  }
  const double s0 = cross(a, b, c), s1 = cross(a, b, d);
  const double t0 = cross(c, d, a), t1 = cross(c, d, b);
  if ((s0 > 0.0) == (s1 > 0.0) && s0 != 0.0 && s1 != 0.0) return false;
  if ((t0 > 0.0) == (t1 > 0.0) && t0 != 0.0 && t1 != 0.0) return false;
  if (s0 == 0.0 && s1 == 0.0) {
    const Eigen::Vector2d u = b - a;
    const double from = (c - a).dot(u), to = (d - a).dot(u);
    return std::max(from, to) >= 0.0 && std::min(from, to) <= u.squaredNorm();
  }
  return true;
}

bool bridge_is_free(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Ring& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    if (segments_meet(a, b, ring[i].at, ring[(i + 1) % ring.size()].at)) return false;
  }
  return true;
}

/// Whether a point lies in the ring's inner angle at a corner. Tells the copies of a corner apart
/// that several bridges start from.
bool in_corner(const Ring& ring, size_t i, const Eigen::Vector2d& p) {
  const size_t n = ring.size();
  const Eigen::Vector2d &a = ring[(i + n - 1) % n].at, &b = ring[i].at, &c = ring[(i + 1) % n].at;
  const double before = cross(a, b, p), after = cross(b, c, p);
  return cross(a, b, c) >= 0.0 ? before > 0.0 && after > 0.0 : before > 0.0 || after > 0.0;
}

/// Joins a hole to the outer ring by the shortest bridge that meets no edge of either nor of the
/// holes that are still to be joined.
void join(const Ring& hole, const std::vector<Ring>& others, Ring* outer) {
  struct Bridge {
    double length;
    size_t outer, hole;
  };
  std::vector<Bridge> bridges;
  for (size_t i = 0; i < outer->size(); ++i) {
    for (size_t j = 0; j < hole.size(); ++j) {
      bridges.push_back({((*outer)[i].at - hole[j].at).squaredNorm(), i, j});
    }
  }
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
  const auto is_free = [&](const Bridge& bridge) {
    const Eigen::Vector2d &a = (*outer)[bridge.outer].at, &b = hole[bridge.hole].at;
    if (!in_corner(*outer, bridge.outer, b)) return false;
    if (!bridge_is_free(a, b, *outer) || !bridge_is_free(a, b, hole)) return false;
    return std::all_of(others.begin(), others.end(),
                       [&](const Ring& other) { return bridge_is_free(a, b, other); });
  };
  auto chosen = std::find_if(bridges.begin(), bridges.end(), is_free);
  if (chosen == bridges.end()) chosen = bridges.begin();
  Ring cut(hole.begin() + chosen->hole, hole.end());
  cut.insert(cut.end(), hole.begin(), hole.begin() + chosen->hole + 1);
  cut.push_back((*outer)[chosen->outer]);
  outer->insert(outer->begin() + chosen->outer + 1, cut.begin(), cut.end());
}

/// Whether the corner is convex and its triangle holds no other corner of the ring.
bool is_ear(const Ring& ring, size_t i) {
  const size_t n = ring.size();
  const Eigen::Vector2d &a = ring[(i + n - 1) % n].at, &b = ring[i].at, &c = ring[(i + 1) % n].at;
  if (!(cross(a, b, c) > 0.0)) return false;
  for (const Corner& corner : ring) {
    const Eigen::Vector2d& p = corner.at;
    if (p == a || p == b || p == c) continue;
    if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
  }
  return true;
}

/// How far an ear is from a sliver: its area over its longest side squared.
double quality(const Ring& ring, size_t i) {
  const size_t n = ring.size();
  const Eigen::Vector2d &a = ring[(i + n - 1) % n].at, &b = ring[i].at, &c = ring[(i + 1) % n].at;
  return cross(a, b, c) /
         std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const Solid& solid, const Face& face) {
  const Eigen::Vector3d normal = newell(solid, face.rings[0]);
  int drop = 0;  // the axis the face is seen along
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  std::vector<Ring> rings;
  for (const std::vector<int>& indices : face.rings) {
    Ring& ring = rings.emplace_back();
    for (const int i : indices) {
      const Eigen::Vector3d& p = solid.vertices[i];
      ring.push_back(
          {i, normal[drop] < 0.0 ? Eigen::Vector2d(p[v], p[u]) : Eigen::Vector2d(p[u], p[v])});
    }
  }
  Ring outer = rings[0];
  while (rings.size() > 1) {
    const Ring hole = rings.back();
    rings.pop_back();
    join(hole, {rings.begin() + 1, rings.end()}, &outer);
  }
  std::vector<std::array<int, 3>> triangles;
  while (outer.size() >= 3) {
    const size_t n = outer.size();
    size_t best = n;
    double best_quality = -std::numeric_limits<double>::infinity();
    for (const bool ears_only : {true, false}) {
      // A ring that is flat or, by rounding, crosses itself may have no ear: then the least bad
      // corner goes, so that the number of triangles and the edges used stay right.
      for (size_t i = 0; i < n; ++i) {
        if (ears_only && n > 3 && !is_ear(outer, i)) continue;
        const double q = quality(outer, i);
        if (q > best_quality) best = i, best_quality = q;
      }
      if (best < n) break;
    }
    if (best == n) best = 0;
    triangles.push_back(
        {outer[(best + n - 1) % n].vertex, outer[best].vertex, outer[(best + 1) % n].vertex});
    outer.erase(outer.begin() + best);
  }
  return triangles;
}

}  // namespace gable
