#include <gable/training/scans/triangle_contact.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace gable {
namespace {

using Eigen::Vector3d;

double segment_distance(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0,
                        const Vector3d& b1) {
  // Closest points of two segments (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
  const Vector3d d1 = a1 - a0, d2 = b1 - b0, r = a0 - b0;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
  const double c = d1.dot(r), b = d1.dot(d2), denominator = a * e - b * b;
  double s =
      denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0 || t > 1.0) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((b * t - c) / a, 0.0, 1.0);
  }
  return (a0 + s * d1 - b0 - t * d2).norm();
}

/// Distance of a point from a triangle's inside: infinite where it does not project into it.
double inside_distance(const Vector3d& p, const TriangleCorners& t) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (int k = 0; k < 3; ++k) {
    if (normal.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) < 0.0) {
      return std::numeric_limits<double>::infinity();
    }
  }
  return std::abs(normal.dot(p - t[0])) / normal.norm();
}

bool edge_crosses(const Vector3d& p, const Vector3d& q, const TriangleCorners& t) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(p - t[0]), to = normal.dot(q - t[0]);
  if (from * to >= 0.0) return false;
  const Vector3d at = p + from / (from - to) * (q - p);
  return inside_distance(at, t) < std::numeric_limits<double>::infinity();
}

}  // namespace

double distance(const TriangleCorners& a, const TriangleCorners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d &a0 = a[i], &a1 = a[(i + 1) % 3], &b0 = b[i], &b1 = b[(i + 1) % 3];
    if (edge_crosses(a0, a1, b) || edge_crosses(b0, b1, a)) return 0.0;
    least = std::min({least, inside_distance(a0, b), inside_distance(b0, a)});
    for (int j = 0; j < 3; ++j) {
      least = std::min(least, segment_distance(a0, a1, b[j], b[(j + 1) % 3]));
    }
  }
  return least;
}

std::vector<std::pair<int, int>> touching_groups(std::span<const TriangleCorners> triangles,
                                                 std::span<const int> group_of, double tolerance) {
  const int n = static_cast<int>(triangles.size());
  std::vector<Vector3d> low(n), high(n);
  for (int i = 0; i < n; ++i) {
    const TriangleCorners& t = triangles[i];
    low[i] = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    high[i] = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return low[i].x() != low[j].x() ? low[i].x() < low[j].x() : i < j;
  });
  std::set<std::pair<int, int>> out;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      const int p = order[i], q = order[j];
      if (low[q].x() > high[p].x() + tolerance) break;
      if (group_of[p] == group_of[q]) continue;
      if (((low[q] - high[p]).array() > tolerance).any()) continue;
      if (((low[p] - high[q]).array() > tolerance).any()) continue;
      const std::pair<int, int> groups = std::minmax(group_of[p], group_of[q]);
      if (out.contains(groups)) continue;
      if (distance(triangles[p], triangles[q]) <= tolerance) out.insert(groups);
    }
  }
  return {out.begin(), out.end()};
}

}  // namespace gable
