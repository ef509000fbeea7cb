#include <gable/engine/scales/outline/facet_boundary.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace gable {
namespace {

using Corner = std::pair<double, double>;

/// The one corner that each boundary corner is followed by; nothing where there are several.
std::optional<std::map<int, int>> boundary_of(const std::vector<Ring>& polygons,
                                              std::map<Corner, int>& number) {
  std::set<std::pair<int, int>> edges;
  for (const Ring& polygon : polygons) {
    const double area = signed_area(polygon);
    if (area == 0.0) return std::nullopt;
    std::vector<int> corners;
    for (const Eigen::Vector2d& p : polygon) {
      corners.push_back(
          number.emplace(Corner(p.x(), p.y()), static_cast<int>(number.size())).first->second);
    }
    if (area < 0.0) std::reverse(corners.begin(), corners.end());
    for (size_t i = 0; i < corners.size(); ++i) {
      const int from = corners[i], to = corners[(i + 1) % corners.size()];
      if (from == to || !edges.emplace(from, to).second) return std::nullopt;
    }
  }
  std::map<int, int> next;
  for (const auto& [from, to] : edges) {
    if (edges.contains({to, from})) continue;
    if (!next.emplace(from, to).second) return std::nullopt;
  }
  return next;
}

/// Without corners on straight edges.
Ring without_flat_corners(const Ring& ring) {
  constexpr double kFlat = 1e-9;  // sine
  Ring out;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d u = ring[i] - (out.empty() ? ring.back() : out.back());
    const Eigen::Vector2d v = ring[(i + 1) % ring.size()] - ring[i];
    const double sine = u.x() * v.y() - u.y() * v.x();
    if (std::abs(sine) > kFlat * u.norm() * v.norm() || u.dot(v) < 0.0) out.push_back(ring[i]);
  }
  return out;
}

}  // namespace

std::optional<std::vector<OutlinedRegion>> union_by_boundary(const std::vector<Ring>& polygons) {
  std::map<Corner, int> number;
  std::optional<std::map<int, int>> next = boundary_of(polygons, number);
  if (!next) return std::nullopt;
  std::vector<Eigen::Vector2d> corners(number.size());
  for (const auto& [corner, n] : number) corners[n] = {corner.first, corner.second};
  std::vector<Ring> rings;
  while (!next->empty()) {
    Ring ring;
    for (auto at = next->begin(); at != next->end();) {
      ring.push_back(corners[at->first]);
      const int to = at->second;
      next->erase(at);
      at = next->find(to);
    }
    rings.push_back(without_flat_corners(ring));
    if (rings.back().size() < 3) return std::nullopt;
  }
  if (!are_simple(rings)) return std::nullopt;

  std::vector<OutlinedRegion> regions;
  for (const Ring& ring : rings) {
    const double area = signed_area(ring);
    if (area > 0.0) regions.push_back({ring, {}, area});
  }
  for (const Ring& ring : rings) {
    const double area = signed_area(ring);
    int around = 0;
    OutlinedRegion* smallest = nullptr;
    for (const Ring& other : rings) {
      if (&other != &ring && ring_holds(other, ring[0]))
        around += signed_area(other) > 0.0 ? 1 : -1;
    }
    if (around != (area > 0.0 ? 0 : 1)) return std::nullopt;
    if (area > 0.0) continue;
    for (OutlinedRegion& region : regions) {
      if (!ring_holds(region.outer, ring[0])) continue;
      if (!smallest || signed_area(region.outer) < signed_area(smallest->outer)) smallest = &region;
    }
    smallest->holes.push_back(ring);
    smallest->area += area;
  }
  return regions;
}

}  // namespace gable
