#include <gable/engine/scales/dissolve_regions.h>
#include <gable/engine/scales/local_planes.h>
#include <gable/engine/scales/point_regions.h>
#include <gable/engine/scales/region_adjacency.h>
#include <gable/engine/scales/relax_regions.h>
#include <gable/engine/scales/shape_plane.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

constexpr double kEpsilonDeviations = 3.0;  ///< epsilon in standard deviations of inliers
constexpr double kReach = 3.5;              ///< how far the tails of noise reach, in the same
constexpr int kRounds = 3;                  ///< of relaxing and dissolving
// Where a cloud has to be thinned for its surfaces to be seen, what is smaller than this share of
// the surroundings in which they are seen is noise.
constexpr double kLeastOfSurroundings = 0.5;

// Normals that come with a scan know more than its points.
void use_given_normals(const Scan& scan, const OrderedCloud& cloud, LocalPlanes* planes) {
  for (int i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& given = scan.normals[cloud.source[i]];
    if (given.squaredNorm() > 0.25f) planes->normals[i] = given;
  }
}

// Points from the flattest surroundings to the roughest.
std::vector<int> flattest_first(const LocalPlanes& planes) {
  std::vector<int> order(planes.deviations.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return planes.deviations[a] != planes.deviations[b]
               ? planes.deviations[a] < planes.deviations[b]
               : a < b;
  });
  return order;
}

class RegionGrower {
 public:
  RegionGrower(const OrderedCloud& cloud, const Neighbours& neighbours, const LocalPlanes& planes,
               double epsilon, const FirstShapesOptions& options)
      : cloud_(cloud),
        neighbours_(neighbours),
        planes_(planes),
        epsilon_(static_cast<float>(epsilon)),
        min_cosine_(static_cast<float>(std::cos(options.max_angle))),
        min_inliers_(options.min_inliers),
        region_of_(cloud.size(), -1) {}

  /// Grows a region from a free point; it is kept if it is large enough.
  void grow(int seed) {
    if (region_of_[seed] >= 0 || planes_.normals[seed].isZero()) return;
    const int region = static_cast<int>(moments_.size());
    normal_ = planes_.normals[seed];
    through_ = cloud_.positions[seed] - planes_.distances[seed] * normal_;
    PointMoments moments;
    moments.add(cloud_.positions[seed].cast<double>());
    members_.assign(1, seed);
    region_of_[seed] = region;
    size_t next_fit = kFirstFit;
    for (size_t i = 0; i < members_.size(); ++i) {
      for (int q : neighbours_.of(members_[i])) {
        if (region_of_[q] >= 0 || !fits(q)) continue;
        region_of_[q] = region;
        members_.push_back(q);
        moments.add(cloud_.positions[q].cast<double>());
      }
      if (members_.size() >= next_fit) {
        refit(moments);
        next_fit = members_.size() + members_.size() / 4;
      }
    }
    if (static_cast<int>(members_.size()) < min_inliers_) {
      for (int p : members_) region_of_[p] = -1;
    } else {
      moments_.push_back(moments);
    }
  }

  std::vector<int> take_regions() { return std::move(region_of_); }
  std::vector<PointMoments> take_moments() { return std::move(moments_); }

 private:
  // The seed's own plane is better than one through fewer points than this.
  static constexpr size_t kFirstFit = 20;
  // And better than one through a region that is not much wider than the noise is thick.
  static constexpr double kFlat = 0.2;

  void refit(const PointMoments& moments) {
    const ShapePlane plane = shape_plane(moments);
    if (plane.rms > kFlat * plane.width) return;
    normal_ = plane.normal.cast<float>();
    through_ = plane.centroid.cast<float>();
  }

  bool fits(int p) const {
    return std::abs(normal_.dot(cloud_.positions[p] - through_)) <= epsilon_ &&
           std::abs(normal_.dot(planes_.normals[p])) >= min_cosine_;
  }

  const OrderedCloud& cloud_;
  const Neighbours& neighbours_;
  const LocalPlanes& planes_;
  const float epsilon_, min_cosine_;
  const int min_inliers_;
  Eigen::Vector3f normal_, through_;
  std::vector<int> members_;
  std::vector<int> region_of_;
  std::vector<PointMoments> moments_;
};

// Turns what growing left behind into shapes: see relax_regions and dissolve_regions.
void settle(const OrderedCloud& cloud, const Neighbours& neighbours,
            const LocalPlanes& local_planes, int thinning, double epsilon,
            const FirstShapesOptions& options, std::vector<int>* region_of,
            std::vector<PointMoments>* moments) {
  RelaxOptions relax;
  relax.epsilon = epsilon;
  relax.deviation = epsilon / kEpsilonDeviations;
  relax.min_inliers = 0;
  relax.threads = options.threads;
  DissolveOptions dissolve;
  dissolve.deviation = relax.deviation;
  dissolve.reach = kReach * relax.deviation;
  dissolve.threads = options.threads;
  for (int i = 0; i < kRounds; ++i) {
    relax_regions(cloud, neighbours, local_planes, relax, region_of, moments);
    dissolve_regions(cloud, neighbours, dissolve, region_of, moments);
  }
  relax.min_inliers = options.min_inliers;
  if (thinning > 1) {
    const double surroundings = static_cast<double>(options.neighbours) * thinning;
    relax.min_inliers =
        std::max(options.min_inliers, static_cast<int>(kLeastOfSurroundings * surroundings));
    // What belonged to the regions that are given up finds others in the sweeps after that.
    relax_regions(cloud, neighbours, local_planes, relax, region_of, moments);
  }
  relax_regions(cloud, neighbours, local_planes, relax, region_of, moments);
}

}  // namespace

FirstShapes grow_point_regions(const Scan& scan, const FirstShapesOptions& options) {
  FirstShapes first;
  first.shape_of.assign(scan.points.size(), -1);
  const OrderedCloud cloud = order_cloud(scan.points);
  first.diagonal = cloud.diagonal;
  const Neighbours neighbours = find_neighbours(cloud, options.neighbours, options.threads);
  if (neighbours.k < 2) return first;
  const SurfaceNoise noise = estimate_surface_noise(cloud, neighbours.k, options.threads);
  LocalPlanes planes = fit_local_planes(cloud, neighbours, noise, options.threads);
  if (!scan.normals.empty() && noise.thinning == 1) {
    use_given_normals(scan, cloud, &planes);
  }
  const double epsilon = std::max(options.epsilon_percent / 100.0 * cloud.diagonal,
                                  options.epsilon_deviations * noise.deviation);
  RegionGrower grower(cloud, neighbours, planes, epsilon, options);
  for (int seed : flattest_first(planes)) grower.grow(seed);
  std::vector<int> region_of = grower.take_regions();
  first.moments = grower.take_moments();
  settle(cloud, neighbours, planes, noise.thinning, epsilon, options, &region_of, &first.moments);
  first.adjacent = adjacent_regions(neighbours, region_of, options.threads);
  for (int i = 0; i < cloud.size(); ++i) first.shape_of[cloud.source[i]] = region_of[i];
  return first;
}

}  // namespace gable
