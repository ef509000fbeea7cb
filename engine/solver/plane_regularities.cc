#include <gable/engine/solver/plane_regularities.h>
#include <gable/engine/solver/plane_uncertainty.h>
#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

namespace gable {
namespace {

// Of planes that have nothing to do with each other: what normals (of either sign), cosines of
// angles and differences of slopes are spread over.
constexpr double kHalfSphere = 2.0 * M_PI;
constexpr double kCosines = 2.0;
constexpr double kSlopes = M_PI / 2.0;
// An angle between inclined planes or a slope in common is chance more often than not: there are
// many pairs, and houses are built to be upright before all else.
constexpr double kOddsOfPairs = 0.3;

// Disjoint sets of planes, each led by its most certain one.
class Groups {
 public:
  explicit Groups(const std::vector<double>& deviations)
      : deviations_(deviations), parent_(deviations.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int leader(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False if they were one group already or if their leaders do not `agree`.
  template <typename Agree>
  bool unite(int a, int b, const Agree& agree) {
    a = leader(a), b = leader(b);
    if (a == b || !agree(a, b)) return false;
    if (std::tie(deviations_[b], b) < std::tie(deviations_[a], a)) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  const std::vector<double>& deviations_;
  std::vector<int> parent_;
};

struct Candidate {
  double most;  ///< that the regularity could be missed by, radians
  int a, b;
  bool operator<(const Candidate& other) const {
    return std::tie(most, a, b) < std::tie(other.most, other.a, other.b);
  }
};

// Tells by how much planes miss a regularity. All answers: the most that it could be missed by, or
// nothing where the miss is outside the tolerance.
class Misses {
 public:
  Misses(const std::vector<OrientedPlane>& planes, const std::vector<PointMoments>& moments,
         const RegularityOptions& options)
      : planes_(planes), options_(options) {
    for (size_t i = 0; i < planes.size(); ++i) {
      uncertainties_.push_back(plane_uncertainty(planes[i], moments[i]));
      const Eigen::Vector3d u = planes[i].normal().unitOrthogonal();
      along_.emplace_back();
      along_.back() << u.transpose(), planes[i].normal().cross(u).transpose();
      slopes_.push_back(
          std::atan2(planes[i].normal().head<2>().norm(), std::abs(planes[i].normal().z())));
    }
  }

  std::vector<double> deviations() const {
    std::vector<double> out;
    for (const PlaneUncertainty& u : uncertainties_) out.push_back(u.angle_deviation());
    return out;
  }

  std::optional<double> horizontal(int i) const {
    return within<2>(planes_[i].normal().head<2>(), uncertainties_[i].normal.topLeftCorner<2, 2>(),
                     kHalfSphere);
  }
  std::optional<double> vertical(int i) const {
    return within<1>(planes_[i].normal().segment<1>(2),
                     uncertainties_[i].normal.bottomRightCorner<1, 1>(), kCosines);
  }
  std::optional<double> parallel(int a, int b) const {
    const auto& along = along_[a];
    return within<2>(
        along * planes_[b].normal(),
        along * (uncertainties_[a].normal + uncertainties_[b].normal) * along.transpose(),
        kHalfSphere);
  }
  std::optional<double> orthogonal(int a, int b) const {
    const Eigen::Vector3d na = planes_[a].normal(), nb = planes_[b].normal();
    const double variance =
        nb.dot(uncertainties_[a].normal * nb) + na.dot(uncertainties_[b].normal * na);
    return within<1>(Vector<1>(na.dot(nb)), Matrix<1>(variance), kOddsOfPairs * kCosines);
  }
  /// Of planes that are neither horizontal nor vertical.
  std::optional<double> equal_slope(int a, int b) const {
    return within<1>(Vector<1>(slopes_[a] - slopes_[b]),
                     Matrix<1>(slope_variance(a) + slope_variance(b)), kOddsOfPairs * kSlopes);
  }
  /// Of planes that are parallel.
  bool coplanar(int a, int b) const { return reaches(a, b) && reaches(b, a); }

 private:
  template <int N>
  using Vector = Eigen::Matrix<double, N, 1>;
  template <int N>
  using Matrix = Eigen::Matrix<double, N, N>;

  // Whether a miss lies within the tolerance, and is likelier where the regularity holds (normally
  // distributed) than where it does not (evenly spread over `range`, radians or steradians): the
  // less certain planes are, the closer they have to be, and planes that could be turned anywhere
  // are nothing in particular.
  template <int N>
  std::optional<double> within(const Vector<N>& miss, const Matrix<N>& covariance,
                               double range) const {
    const double own = options_.angle_tolerance / options_.deviations;  // spread of exact planes
    const Matrix<N> spread = covariance + own * own * Matrix<N>::Identity();
    const double squares = miss.dot(spread.inverse() * miss);
    if (squares > options_.deviations * options_.deviations) return std::nullopt;
    const double density =
        std::exp(-0.5 * squares) / std::sqrt(std::pow(2.0 * M_PI, N) * spread.determinant());
    if (density * range < 1.0) return std::nullopt;
    return miss.norm() + options_.deviations * std::sqrt(covariance.trace());
  }

  double slope_variance(int i) const {
    const double sine = std::sin(slopes_[i]);
    return uncertainties_[i].normal(2, 2) / std::max(1e-6, sine * sine);
  }

  // Whether plane a passes through b's centroid.
  bool reaches(int a, int b) const {
    const PlaneUncertainty &ua = uncertainties_[a], &ub = uncertainties_[b];
    const double distance = std::abs(planes_[a].signed_distance(ub.centroid));
    const double variance = ua.variance_at(ub.centroid) + ub.distance;
    const double tolerance =
        std::hypot(options_.distance_tolerance, options_.deviations * std::sqrt(variance));
    return distance <=
           std::min(tolerance, std::max(options_.distance_tolerance, std::max(ua.noise, ub.noise)));
  }

  const std::vector<OrientedPlane>& planes_;
  const RegularityOptions& options_;
  std::vector<PlaneUncertainty> uncertainties_;
  std::vector<Eigen::Matrix<double, 2, 3>> along_;  ///< per plane two directions along it
  std::vector<double> slopes_;                      ///< from horizontal, radians
};

}  // namespace

std::string check(const RegularityOptions& options) {
  if (!(options.angle_tolerance > 0.0 && options.angle_tolerance <= 0.5)) {
    return "angle_tolerance must lie in (0, 0.5]";
  }
  if (!(options.distance_tolerance > 0.0 && options.distance_tolerance <= 10.0)) {
    return "distance_tolerance must lie in (0, 10]";
  }
  if (!(options.deviations >= 1.0 && options.deviations <= 10.0)) {
    return "deviations must lie in [1, 10]";
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
  const Misses misses(planes, moments, options);
  const std::vector<double> deviations = misses.deviations();

  std::vector<Candidate> parallel, orthogonal, equal_slope;
  const auto look_at = [&](int a, int b) {
    if (const auto most = misses.parallel(a, b)) {
      parallel.push_back({*most, a, b});
    } else {
      if (const auto right = misses.orthogonal(a, b)) orthogonal.push_back({*right, a, b});
      if (const auto slope = misses.equal_slope(a, b)) equal_slope.push_back({*slope, a, b});
    }
  };
  if (pairs.empty()) {
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) look_at(a, b);
    }
  } else {
    for (const auto& [a, b] : pairs) look_at(std::min(a, b), std::max(a, b));
  }
  for (auto* candidates : {&parallel, &orthogonal, &equal_slope}) {
    std::sort(candidates->begin(), candidates->end());
  }

  // Coplanar pairs first: they make their planes parallel as well.
  std::vector<PlaneRegularity> found;
  Groups same_plane(deviations), same_direction(deviations), same_slope(deviations);
  const auto agree = [&](int a, int b) { return misses.parallel(a, b).has_value(); };
  const auto coincide = [&](int a, int b) { return agree(a, b) && misses.coplanar(a, b); };
  for (const Candidate& c : parallel) {
    if (!misses.coplanar(c.a, c.b) || !same_plane.unite(c.a, c.b, coincide)) continue;
    same_direction.unite(c.a, c.b, agree);
    found.push_back({RegularityKind::kCoplanar, c.a, c.b});
  }
  std::vector<PlaneRegularity> parallels;
  for (const Candidate& c : parallel) {
    if (same_direction.unite(c.a, c.b, agree)) {
      parallels.push_back({RegularityKind::kParallel, c.a, c.b});
    }
  }
  // A group is horizontal or vertical as its leader is.
  std::vector<char> horizontal(n, 0), vertical(n, 0);
  for (int i = 0; i < n; ++i) {
    const int leader = same_direction.leader(i);
    horizontal[i] = misses.horizontal(leader).has_value();
    vertical[i] = !horizontal[i] && misses.vertical(leader).has_value();
    if (horizontal[i]) found.push_back({RegularityKind::kHorizontal, i});
    if (vertical[i]) found.push_back({RegularityKind::kVertical, i});
  }
  for (const PlaneRegularity& p : parallels) {
    if (!horizontal[p.a]) found.push_back(p);
  }
  std::set<std::pair<int, int>> related;
  for (const Candidate& c : orthogonal) {
    if ((horizontal[c.a] && vertical[c.b]) || (vertical[c.a] && horizontal[c.b])) continue;
    const int a = same_direction.leader(c.a), b = same_direction.leader(c.b);
    if (a == b || !misses.orthogonal(a, b) || !related.insert(std::minmax(a, b)).second) continue;
    found.push_back({RegularityKind::kOrthogonal, c.a, c.b});
  }
  const auto as_steep = [&](int a, int b) { return misses.equal_slope(a, b).has_value(); };
  for (int i = 0; i < n; ++i) {  // parallel planes are of equal slope without saying
    same_slope.unite(i, same_direction.leader(i), [](int, int) { return true; });
  }
  for (const Candidate& c : equal_slope) {
    if (horizontal[c.a] || horizontal[c.b] || vertical[c.a] || vertical[c.b]) continue;
    if (!same_slope.unite(c.a, c.b, as_steep)) continue;
    found.push_back({RegularityKind::kEqualSlope, c.a, c.b});
  }
  return found;
}

}  // namespace gable
