#include <gable/engine/parallel_ranges.h>
#include <gable/engine/scales/cloud_cells.h>
#include <gable/engine/scales/local_planes.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Surroundings are flat where the RMS distance to their plane is below this share of their extent
// (the smaller standard deviation along the plane). A ball has 1.
constexpr double kFlat = 1.0 / 3.0;
// Surroundings this much narrower than long are a line, which has no plane.
constexpr double kLine = 1e-3;
// Edges, clutter and outliers are never flat. Where this share of the surroundings is, the surfaces
// are seen; in small or cluttered objects, where it never is, they are seen best where about as
// many are flat as ever.
constexpr double kMost = 0.5;
constexpr double kNearly = 0.8;
// Where fewer are flat, the surfaces are not seen yet.
constexpr double kFewest = 0.1;
// Points of a neighbourhood in a noisy cloud, over those that reach as far as in the thinned cloud.
constexpr double kWide = 0.5;
constexpr size_t kNumSamples = 2000;
constexpr size_t kFewestThinned = 500;

struct Spread {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();        ///< relative to the point
  Eigen::Vector3d deviations = Eigen::Vector3d::Zero();  ///< standard, along the axes, rising
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();

  bool is_plane() const { return deviations[1] > kLine * deviations[2]; }
};

// Principal axes of points around one.
Spread spread_around(const Eigen::Vector3f& point, const std::vector<Eigen::Vector3f>& cloud,
                     std::span<const int> neighbours) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (int j : neighbours) {
    const Eigen::Vector3f d = cloud[j] - point;
    sum += d;
    xx += d.x() * d.x(), xy += d.x() * d.y(), xz += d.x() * d.z();
    yy += d.y() * d.y(), yz += d.y() * d.z(), zz += d.z() * d.z();
  }
  // The point itself counts as well: it adds nothing but its one.
  const double n = neighbours.size() + 1.0;
  const Eigen::Vector3d mean = sum.cast<double>() / n;
  Eigen::Matrix3d covariance;
  covariance << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  covariance = covariance / n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(covariance);
  return {mean, eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt(), eigen.eigenvectors().col(0)};
}

// The same from moments.
Spread spread_of(const PointMoments& moments, const Eigen::Vector3f& point) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(moments.scatter() / moments.weight);
  return {moments.centroid() - point.cast<double>(), eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt(),
          eigen.eigenvectors().col(0)};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Eigen::Vector3f> every(size_t step, const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3f> out;
  for (size_t i = step / 2; i < points.size(); i += step) out.push_back(points[i]);
  return out;
}

}  // namespace

SurfaceNoise estimate_surface_noise(const OrderedCloud& cloud, int neighbours, int threads) {
  const std::vector<Eigen::Vector3f> samples =
      every(std::max<size_t>(1, cloud.positions.size() / kNumSamples), cloud.positions);
  std::vector<SurfaceNoise> seen;
  std::vector<double> shares;
  for (int thinning = 1;; thinning *= 2) {
    const std::vector<Eigen::Vector3f> part = every(thinning, cloud.positions);
    if (thinning > 1 && part.size() < kFewestThinned) break;
    const Neighbours around = find_neighbours(part, samples, 2 * neighbours, threads);
    std::vector<double> flat;
    size_t planes = 0;
    for (size_t i = 0; i < samples.size(); ++i) {
      const Spread spread = spread_around(samples[i], part, around.of(static_cast<int>(i)));
      if (!spread.is_plane()) continue;
      ++planes;
      if (spread.deviations[0] < kFlat * spread.deviations[1]) flat.push_back(spread.deviations[0]);
    }
    // A plane through n points takes three of them to itself.
    const double taken = std::sqrt((around.k + 1.0) / std::max(1.0, around.k - 2.0));
    seen.push_back({taken * median(flat), thinning});
    shares.push_back(static_cast<double>(flat.size()) / std::max<double>(1.0, planes));
    if (shares.back() >= kMost) return seen.back();
    // Past the best; in a wide scene all of it looks flat in the end.
    const double best = *std::max_element(shares.begin(), shares.end());
    if (best > kFewest && shares.back() < kNearly * best) break;
  }
  const double enough = kNearly * *std::max_element(shares.begin(), shares.end());
  for (size_t i = 0; i < seen.size(); ++i) {
    if (shares[i] >= enough) return seen[i];
  }
  return {};
}

namespace {

LocalPlanes no_planes(size_t count) {
  LocalPlanes planes;
  planes.normals.assign(count, Eigen::Vector3f::Zero());
  planes.distances.assign(count, 0.0f);
  planes.deviations.assign(count, 0.0f);
  return planes;
}

void set_plane(size_t point, const Spread& spread, LocalPlanes* planes) {
  if (!spread.is_plane()) return;
  planes->normals[point] = spread.normal.cast<float>();
  planes->distances[point] = static_cast<float>(-spread.normal.dot(spread.mean));
  planes->deviations[point] = static_cast<float>(spread.deviations[0]);
}

}  // namespace

LocalPlanes fit_local_planes(const OrderedCloud& cloud, const Neighbours& neighbours,
                             const SurfaceNoise& noise, int threads) {
  LocalPlanes planes = no_planes(cloud.positions.size());
  if (neighbours.k < 2) return planes;
  if (noise.thinning == 1) {
    for_ranges(cloud.positions.size(), threads, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const auto around = neighbours.of(static_cast<int>(i));
        set_plane(i, spread_around(cloud.positions[i], cloud.positions, around), &planes);
      }
    });
    return planes;
  }
  // All points of a neighbourhood half as wide as that of the thinned cloud say as much about the
  // plane, and blur edges less. Summed up in cells, they are few.
  const double points = kWide * neighbours.k * noise.thinning;
  const CloudCells cells(cloud, points / neighbours.k / 2.0);
  const int k = static_cast<int>(std::ceil(points * cells.size() / cloud.size()));
  for_neighbours(cells.centroids(), cloud.positions, k, threads,
                 [&](size_t i, std::span<const int> around) {
                   PointMoments moments;
                   for (int c : around) moments += cells.moments(c);
                   set_plane(i, spread_of(moments, cloud.positions[i]), &planes);
                 });
  return planes;
}

}  // namespace gable
