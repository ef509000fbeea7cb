#include <gable/engine/solver/plane_regularities.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace gable {
namespace {

// Disjoint sets of planes.
class Groups {
 public:
  explicit Groups(size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False if they were one group already.
  bool unite(int a, int b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

struct Candidate {
  double sine;  ///< of the angle by which the regularity is missed
  int a, b;
  bool coplanar;
  bool operator<(const Candidate& other) const {
    return std::tie(sine, a, b) < std::tie(other.sine, other.a, other.b);
  }
};

}  // namespace

std::string check(const RegularityOptions& options) {
  if (!(options.angle_tolerance > 0.0 && options.angle_tolerance <= 0.5)) {
    return "angle_tolerance must lie in (0, 0.5]";
  }
  if (!(options.distance_tolerance > 0.0 && options.distance_tolerance <= 10.0)) {
    return "distance_tolerance must lie in (0, 10]";
  }
  return "";
}

std::vector<PlaneRegularity> detect_regularities(const std::vector<OrientedPlane>& planes,
                                                 const std::vector<PointMoments>& moments,
                                                 const std::vector<std::pair<int, int>>& pairs,
                                                 const RegularityOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK_EQ(planes.size(), moments.size());
  const int n = static_cast<int>(planes.size());
  const double tolerance = std::sin(options.angle_tolerance);
  std::vector<PlaneRegularity> found;

  std::vector<char> horizontal(n, 0), vertical(n, 0);
  for (int i = 0; i < n; ++i) {
    horizontal[i] = planes[i].normal().head<2>().norm() <= tolerance;
    vertical[i] = std::abs(planes[i].normal().z()) <= tolerance;
    if (horizontal[i]) found.push_back({RegularityKind::kHorizontal, i});
    if (vertical[i]) found.push_back({RegularityKind::kVertical, i});
  }

  std::vector<Candidate> parallel, orthogonal;
  const auto look_at = [&](int a, int b) {
    const double sine = planes[a].normal().cross(planes[b].normal()).norm();
    const double cosine = std::abs(planes[a].normal().dot(planes[b].normal()));
    if (sine <= tolerance) {
      const double distance = std::max(std::abs(planes[a].signed_distance(moments[b].centroid())),
                                       std::abs(planes[b].signed_distance(moments[a].centroid())));
      parallel.push_back({sine, a, b, distance <= options.distance_tolerance});
    } else if (cosine <= tolerance) {
      orthogonal.push_back({cosine, a, b, false});
    }
  };
  if (pairs.empty()) {
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) look_at(a, b);
    }
  } else {
    for (const auto& [a, b] : pairs) look_at(std::min(a, b), std::max(a, b));
  }
  std::sort(parallel.begin(), parallel.end());
  std::sort(orthogonal.begin(), orthogonal.end());

  // Coplanar pairs first: they make their planes parallel as well.
  Groups same_plane(n), same_direction(n);
  for (const Candidate& c : parallel) {
    if (!c.coplanar || !same_plane.unite(c.a, c.b)) continue;
    same_direction.unite(c.a, c.b);
    found.push_back({RegularityKind::kCoplanar, c.a, c.b});
  }
  for (const Candidate& c : parallel) {
    const bool united = same_direction.unite(c.a, c.b);
    if (united && !(horizontal[c.a] && horizontal[c.b])) {
      found.push_back({RegularityKind::kParallel, c.a, c.b});
    }
  }
  std::set<std::pair<int, int>> related;
  for (const Candidate& c : orthogonal) {
    if ((horizontal[c.a] && vertical[c.b]) || (vertical[c.a] && horizontal[c.b])) continue;
    const int a = same_direction.find(c.a), b = same_direction.find(c.b);
    if (a == b || !related.insert(std::minmax(a, b)).second) continue;
    found.push_back({RegularityKind::kOrthogonal, c.a, c.b});
  }
  return found;
}

}  // namespace gable
