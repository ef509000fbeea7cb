#include <gable/engine/scales/refit_shapes.h>
#include <gable/engine/scales/shape_samples.h>
#include <gable/engine/solver/unstrained_refinement.h>
#include <gable/engine/stopwatch.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace gable {
namespace {

// Points' worth of the typical noise of all shapes that a shape's own noise is mixed with, since a
// handful of points may lie on a plane by chance.
constexpr double kNoisePrior = 10.0;

// Outside this many standard deviations a point says nothing about how certain a plane is.
constexpr double kTrim = 3.0;

OrientedPlane least_squares(const PointMoments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.scatter());
  Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  // Upwards, or to +x, then +y.
  const double side = std::abs(normal.z()) > 1e-9   ? normal.z()
                      : std::abs(normal.x()) > 1e-9 ? normal.x()
                                                    : normal.y();
  if (side < 0.0) normal = -normal;
  return {normal, normal.dot(moments.centroid())};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The standard deviations of the points' distances, from the medians of their sizes, which
// outliers leave alone (1.4826 makes them those of a normal distribution).
void measure_noise(const std::vector<Eigen::Vector3d>& points,
                   const std::vector<OrientedPlane>& planes, double least,
                   std::vector<PlaneSupport>* supports) {
  std::vector<double> own, all;
  for (size_t i = 0; i < planes.size(); ++i) {
    std::vector<double> sizes;
    for (int m : (*supports)[i].members) {
      sizes.push_back(std::abs(planes[i].signed_distance(points[m])));
    }
    all.insert(all.end(), sizes.begin(), sizes.end());
    own.push_back(1.4826 * median(std::move(sizes)));
  }
  const double typical = 1.4826 * median(std::move(all));
  for (size_t i = 0; i < planes.size(); ++i) {
    const double n = static_cast<double>((*supports)[i].members.size());
    const double squares =
        (n * own[i] * own[i] + kNoisePrior * typical * typical) / (n + kNoisePrior);
    (*supports)[i].noise = std::max(least, std::sqrt(squares));
  }
}

PointMoments trimmed_moments(const std::vector<Eigen::Vector3d>& points,
                             const PlaneSupport& support, const OrientedPlane& plane) {
  PlaneSupport inliers;
  for (size_t k = 0; k < support.members.size(); ++k) {
    const int m = support.members[k];
    if (std::abs(plane.signed_distance(points[m])) > kTrim * support.noise) continue;
    inliers.members.push_back(m);
    if (!support.weights.empty()) inliers.weights.push_back(support.weights[k]);
  }
  return moments_of(points, inliers);
}

// The pairs to look for regularities in: each plane with its nearest ones, by the gap between the
// spheres around their points. What is built together is regular; among many planes far apart some
// always agree by chance.
std::vector<std::pair<int, int>> near_pairs(const std::vector<PointMoments>& moments) {
  constexpr int kNearest = 20;
  const int n = static_cast<int>(moments.size());
  std::vector<Eigen::Vector3d> centers;
  std::vector<double> radii;
  for (const PointMoments& m : moments) {
    centers.push_back(m.centroid());
    radii.push_back(std::sqrt(3.0 * m.scatter().trace() / std::max(1e-300, m.weight)));
  }
  std::set<std::pair<int, int>> pairs;
  std::vector<std::pair<double, int>> gaps;
  for (int a = 0; a < n; ++a) {
    gaps.clear();
    for (int b = 0; b < n; ++b) {
      if (b != a) gaps.emplace_back((centers[a] - centers[b]).norm() - radii[a] - radii[b], b);
    }
    const auto end = gaps.begin() + std::min<size_t>(gaps.size(), kNearest);
    std::partial_sort(gaps.begin(), end, gaps.end());
    for (auto gap = gaps.begin(); gap != end; ++gap) pairs.insert(std::minmax(a, gap->second));
  }
  return {pairs.begin(), pairs.end()};
}

double rms(const std::vector<PointMoments>& moments, const std::vector<OrientedPlane>& planes) {
  double squares = 0.0, weight = 0.0;
  for (size_t i = 0; i < planes.size(); ++i) {
    const double off = planes[i].signed_distance(moments[i].centroid());
    squares += planes[i].normal().dot(moments[i].scatter() * planes[i].normal()) +
               moments[i].weight * off * off;
    weight += moments[i].weight;
  }
  return weight > 0.0 ? std::sqrt(std::max(0.0, squares) / weight) : 0.0;
}

double diagonal(const std::vector<Eigen::Vector3d>& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) box.extend(p);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

}  // namespace

std::string check(const RefitOptions& options) {
  PlaneRefinementOptions refinement;
  refinement.loss_scale = options.loss_scale;
  refinement.regularity_strength = options.regularity_strength;
  if (const std::string wrong = check(refinement); !wrong.empty()) return wrong;
  RegularityOptions regularity;
  regularity.angle_tolerance = options.angle_tolerance;
  regularity.deviations = options.deviations;
  if (const std::string wrong = check(regularity); !wrong.empty()) return wrong;
  return "";
}

PlaneRefit refit_shapes(const Scan& scan, const std::vector<int>& shape_of,
                        const RefitOptions& options) {
  CHECK(check(options).empty()) << check(options);
  const Stopwatch watch;
  const ShapeSamples samples = sample_shapes(scan, shape_of);
  PlaneRefit out;
  std::vector<PointMoments> all;
  std::vector<int> fitted;  // shapes that have a plane to refit
  for (size_t i = 0; i < samples.supports.size(); ++i) {
    all.push_back(moments_of(samples.points, samples.supports[i]));
    out.before.push_back(least_squares(all.back()));
    if (samples.supports[i].members.size() >= 3) fitted.push_back(static_cast<int>(i));
  }
  out.after = out.before;

  std::vector<PlaneSupport> supports;
  std::vector<OrientedPlane> planes;
  for (int i : fitted) {
    supports.push_back(samples.supports[i]);
    planes.push_back(out.before[i]);
  }
  const double size = diagonal(scan.points);
  const double least_noise = std::max(1e-12, 1e-6 * size);
  measure_noise(samples.points, planes, least_noise, &supports);

  // Each alone first: regularities are looked for among planes that outliers have let go.
  PlaneRefinementOptions refinement;
  refinement.loss = options.loss;
  refinement.loss_scale = options.loss_scale;
  refinement.regularity_strength = options.regularity_strength;
  std::vector<OrientedPlane> alone = planes;
  if (!planes.empty()) refine_planes(samples.points, supports, {}, refinement, &alone);
  measure_noise(samples.points, alone, least_noise, &supports);

  if (!planes.empty()) {
    std::vector<PointMoments> moments;
    for (size_t i = 0; i < planes.size(); ++i) {
      moments.push_back(trimmed_moments(samples.points, supports[i], alone[i]));
    }
    RegularityOptions tolerances;
    tolerances.angle_tolerance = options.angle_tolerance;
    tolerances.deviations = options.deviations;
    std::vector<double> noises;
    for (const PlaneSupport& support : supports) noises.push_back(support.noise);
    tolerances.distance_tolerance = std::clamp(median(std::move(noises)), 1e-9, 10.0);
    if (options.regularities) {
      out.regularities = detect_regularities(alone, moments, near_pairs(moments), tolerances);
    }
    const PlaneRefinementSummary summary =
        refine_unstrained(samples.points, supports, alone, moments, tolerances, refinement,
                          &out.regularities, &planes);
    out.cost_before = summary.initial_cost;
    out.cost_after = summary.final_cost;
    out.reweightings = summary.reweightings;
    out.termination = summary.termination;
  }
  for (PlaneRegularity& regularity : out.regularities) {
    regularity.a = fitted[regularity.a];
    if (regularity.b >= 0) regularity.b = fitted[regularity.b];
  }
  for (size_t k = 0; k < fitted.size(); ++k) out.after[fitted[k]] = planes[k];
  out.rms_before = rms(all, out.before);
  out.rms_after = rms(all, out.after);
  out.time_ms = watch.ms();
  return out;
}

}  // namespace gable
