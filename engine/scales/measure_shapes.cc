#include <gable/engine/scales/measure_shapes.h>
#include <gable/engine/scales/shape_samples.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Twice the area of a facet times its normal.
Eigen::Vector3d area_vector(const Scan& scan, size_t facet) {
  const auto corners = scan.facets[facet];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t i = 2; i < corners.size(); ++i) {
    const Eigen::Vector3d& origin = scan.points[corners[0]];
    sum += (scan.points[corners[i - 1]] - origin).cross(scan.points[corners[i]] - origin);
  }
  return sum;
}

// The side that a shape's elements face, 0 where they do not say.
std::vector<Eigen::Vector3d> facing(const Scan& scan, const std::vector<int>& shape_of,
                                    size_t num_shapes) {
  std::vector<Eigen::Vector3d> out(num_shapes, Eigen::Vector3d::Zero());
  if (!scan.is_mesh() && scan.normals.empty()) return out;
  for (size_t i = 0; i < shape_of.size(); ++i) {
    if (shape_of[i] < 0) continue;
    out[shape_of[i]] += scan.is_mesh() ? area_vector(scan, i) : scan.normals[i].cast<double>();
  }
  return out;
}

bool faces_away(const Eigen::Vector3d& normal, const Eigen::Vector3d& facing) {
  if (const double side = normal.dot(facing); side != 0.0) return side < 0.0;
  if (std::abs(normal.z()) > 1e-9) return normal.z() < 0.0;
  if (std::abs(normal.x()) > 1e-9) return normal.x() < 0.0;
  return normal.y() < 0.0;
}

// Points, or square metres.
double weight_of_elements(const Scan& scan) {
  if (!scan.is_mesh()) return static_cast<double>(scan.points.size());
  const ShapeSamples whole = sample_shapes(scan, std::vector<int>(scan.facets.size(), 0));
  double weight = 0.0;
  for (double w : whole.supports[0].weights) weight += w;
  return weight * whole.weight_unit;
}

}  // namespace

ScaleShapes measure_shapes(const Scan& scan, const std::vector<int>& shape_of,
                           const std::vector<OrientedPlane>& planes) {
  const ShapeSamples samples = sample_shapes(scan, shape_of);
  CHECK_GE(planes.size(), samples.supports.size());
  const std::vector<Eigen::Vector3d> sides = facing(scan, shape_of, planes.size());
  ScaleShapes out;
  out.shape_of = shape_of;
  double squares = 0.0, weight = 0.0;
  for (size_t i = 0; i < planes.size(); ++i) {
    PlanarShape shape;
    shape.plane = planes[i];
    if (faces_away(planes[i].normal(), sides[i])) {
      shape.plane = {-planes[i].normal(), -planes[i].offset()};
    }
    if (i < samples.supports.size()) {
      const PointMoments moments = moments_of(samples.points, samples.supports[i]);
      const Eigen::Vector3d normal = shape.plane.normal();
      shape.centroid = moments.centroid();
      const double off = shape.plane.signed_distance(shape.centroid);
      const double own =
          std::max(0.0, normal.dot(moments.scatter() * normal)) + moments.weight * off * off;
      if (moments.weight > 0.0) shape.rms = std::sqrt(own / moments.weight);
      squares += own;
      weight += moments.weight;
    }
    out.shapes.push_back(shape);
  }
  for (int shape : shape_of) {
    if (shape >= 0) ++out.shapes[shape].inliers;
  }
  if (weight > 0.0) out.rms = std::sqrt(squares / weight);
  const double all = weight_of_elements(scan);
  if (all > 0.0) out.coverage = std::min(1.0, weight * samples.weight_unit / all);
  return out;
}

}  // namespace gable
