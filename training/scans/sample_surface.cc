#include <gable/grammar/random.h>
#include <gable/training/scans/sample_surface.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace gable {
namespace {

/// Added to every side of the bounding box that outliers lie in, as a share of its extent.
constexpr double kBoxMargin = 0.05;

/// Draws triangles in proportion to their areas.
class TriangleDraw {
 public:
  TriangleDraw(const LabelledSurface& surface, double least_normal_z) {
    for (const auto& [a, b, c] : surface.triangles) {
      const Eigen::Vector3d& origin = surface.vertices[a];
      const Eigen::Vector3d normal =
          (surface.vertices[b] - origin).cross(surface.vertices[c] - origin);
      const double twice_area = normal.norm();
      total_ += normal.z() >= least_normal_z * twice_area ? twice_area : 0.0;
      sums_.push_back(total_);
      normals_.push_back(normal.normalized().cast<float>());
    }
    CHECK_GT(total_, 0.0) << "no triangle to sample";
  }

  size_t draw(Random* random) const {
    const double at = random->uniform(0.0, total_);
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), at);
    return std::min<size_t>(found - sums_.begin(), sums_.size() - 1);
  }
  const Eigen::Vector3f& normal(size_t triangle) const { return normals_[triangle]; }

 private:
  std::vector<double> sums_;
  std::vector<Eigen::Vector3f> normals_;
  double total_ = 0.0;
};

/// Uniform in a triangle (Turk 1990, the square folded along its diagonal).
Eigen::Vector3d point_in(const LabelledSurface& surface, size_t triangle, Random* random) {
  const auto& [a, b, c] = surface.triangles[triangle];
  double s = random->uniform(0.0, 1.0), t = random->uniform(0.0, 1.0);
  if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
  const Eigen::Vector3d& origin = surface.vertices[a];
  return origin + s * (surface.vertices[b] - origin) + t * (surface.vertices[c] - origin);
}

Eigen::AlignedBox3d box_of(const LabelledSurface& surface) {
  Eigen::AlignedBox3d box;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    for (const int corner : triangle) box.extend(surface.vertices[corner]);
  }
  return box;
}

}  // namespace

std::string check(const SampleOptions& options) {
  if (options.num_points < 1 || options.num_points > 1000000000) {
    return "num_points must be in [1, 1e9]";
  }
  if (!(options.noise >= 0.0 && options.noise <= 1.0)) return "noise must be in [0, 1]";
  if (!(options.outlier_share >= 0.0 && options.outlier_share <= 1.0)) {
    return "outlier_share must be in [0, 1]";
  }
  if (!(options.least_normal_z >= -1.0 && options.least_normal_z <= 1.0)) {
    return "least_normal_z must be in [-1, 1]";
  }
  return "";
}

Scan sample_surface(const LabelledSurface& surface, const SampleOptions& options) {
  CHECK_EQ(check(options), "");
  CHECK_EQ(surface.planes.size(), surface.triangles.size());
  const TriangleDraw triangles(surface, options.least_normal_z);
  const Eigen::AlignedBox3d box = box_of(surface);
  const double sigma = options.noise * box.diagonal().norm();
  const Eigen::Vector3d margin = kBoxMargin * box.sizes();
  const size_t n = options.num_points;
  const size_t num_outliers = std::llround(options.outlier_share * n);

  Random random(options.seed);
  std::vector<size_t> place(n);
  std::iota(place.begin(), place.end(), size_t{0});
  Random shuffle = random.fork();
  for (size_t i = n - 1; i > 0; --i) {
    std::swap(place[i], place[shuffle.integer(0, static_cast<int>(i))]);
  }

  Scan scan;
  scan.points.resize(n);
  if (options.with_normals) scan.normals.assign(n, Eigen::Vector3f::Zero());
  std::array<std::vector<int>*, kNumKnownScales> labels;
  for (int scale = 0; scale < kNumKnownScales; ++scale) {
    labels[scale] = &scan.labels["scale_" + std::to_string(scale + 1)];
    labels[scale]->assign(n, -1);
  }
  for (size_t i = 0; i < n; ++i) {
    Eigen::Vector3d& point = scan.points[place[i]];
    if (i < num_outliers) {
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] =
            random.uniform(box.min()[axis] - margin[axis], box.max()[axis] + margin[axis]);
      }
      continue;
    }
    const size_t triangle = triangles.draw(&random);
    point = point_in(surface, triangle, &random);
    if (sigma > 0.0) {
      for (int axis = 0; axis < 3; ++axis) point[axis] += random.normal(sigma);
    }
    if (options.with_normals) scan.normals[place[i]] = triangles.normal(triangle);
    for (int scale = 0; scale < kNumKnownScales; ++scale) {
      (*labels[scale])[place[i]] = surface.planes[triangle][scale];
    }
  }
  return scan;
}

}  // namespace gable
