#include <gable/engine/scales/shape_samples.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace gable {
namespace {

void add_facet(const Scan& scan, std::span<const int> corners, ShapeSamples* samples,
               PlaneSupport* support, double* total_area) {
  for (size_t i = 2; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = scan.points[corners[0]];
    const Eigen::Vector3d& b = scan.points[corners[i - 1]];
    const Eigen::Vector3d& c = scan.points[corners[i]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    if (!(area > 0.0)) continue;
    *total_area += area;
    for (const Eigen::Vector3d& middle :
         {Eigen::Vector3d(0.5 * (a + b)), Eigen::Vector3d(0.5 * (b + c)),
          Eigen::Vector3d(0.5 * (c + a))}) {
      support->members.push_back(static_cast<int>(samples->points.size()));
      support->weights.push_back(area / 3.0);
      samples->points.push_back(middle);
    }
  }
}

}  // namespace

ShapeSamples sample_shapes(const Scan& scan, const std::vector<int>& shape_of) {
  CHECK_EQ(shape_of.size(), scan.num_elements());
  ShapeSamples samples;
  const auto most = std::max_element(shape_of.begin(), shape_of.end());
  samples.supports.resize(most == shape_of.end() ? 0 : std::max(0, *most + 1));
  if (!scan.is_mesh()) {
    samples.points = scan.points;
    for (size_t i = 0; i < shape_of.size(); ++i) {
      if (shape_of[i] >= 0) samples.supports[shape_of[i]].members.push_back(static_cast<int>(i));
    }
    return samples;
  }
  double total_area = 0.0;
  size_t facets = 0;
  for (size_t i = 0; i < shape_of.size(); ++i) {
    if (shape_of[i] < 0) continue;
    add_facet(scan, scan.facets[i], &samples, &samples.supports[shape_of[i]], &total_area);
    ++facets;
  }
  if (total_area > 0.0) samples.weight_unit = total_area / facets;
  for (PlaneSupport& support : samples.supports) {
    for (double& weight : support.weights) weight /= samples.weight_unit;
  }
  return samples;
}

PointMoments moments_of(const std::vector<Eigen::Vector3d>& points, const PlaneSupport& support) {
  PointMoments moments;
  if (!support.members.empty()) moments.reference = points[support.members.front()];
  for (size_t k = 0; k < support.members.size(); ++k) {
    moments.add(points[support.members[k]], support.weights.empty() ? 1.0 : support.weights[k]);
  }
  return moments;
}

}  // namespace gable
