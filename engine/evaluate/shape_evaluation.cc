#include <gable/engine/evaluate/rand_index.h>
#include <gable/engine/evaluate/shape_evaluation.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace gable {
namespace {

double facet_area(const Scan& scan, size_t facet) {
  const auto corners = scan.facets[facet];
  const Eigen::Vector3d& origin = scan.points[corners[0]];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t i = 2; i < corners.size(); ++i) {
    sum += (scan.points[corners[i - 1]] - origin).cross(scan.points[corners[i]] - origin);
  }
  return 0.5 * sum.norm();
}

/// Calls take(point, weight) for all points of an element.
template <typename Take>
void for_points(const Scan& scan, size_t element, double size, const Take& take) {
  if (!scan.is_mesh()) return take(scan.points[element], size);
  const auto corners = scan.facets[element];
  for (const int corner : corners) {
    take(scan.points[corner], size / static_cast<double>(corners.size()));
  }
}

}  // namespace

ShapeEvaluation evaluate_shapes(const Scan& scan, const std::vector<int>& shape_of) {
  CHECK_EQ(shape_of.size(), scan.num_elements());
  struct Sums {
    double weight = 0.0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  };
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : scan.points) box.extend(point);
  // Two passes, so that coordinates far from the origin cost no digits.
  std::map<int, Sums> shapes;
  double all = 0.0, covered = 0.0;
  std::vector<double> sizes(shape_of.size(), 1.0);
  for (size_t i = 0; i < shape_of.size(); ++i) {
    if (scan.is_mesh()) sizes[i] = facet_area(scan, i);
    all += sizes[i];
    if (shape_of[i] < 0) continue;
    covered += sizes[i];
    Sums& sums = shapes[shape_of[i]];
    for_points(scan, i, sizes[i], [&](const Eigen::Vector3d& point, double weight) {
      sums.weight += weight;
      sums.first += weight * (point - box.min());
    });
  }
  for (size_t i = 0; i < shape_of.size(); ++i) {
    if (shape_of[i] < 0) continue;
    Sums& sums = shapes[shape_of[i]];
    if (sums.weight <= 0.0) continue;
    const Eigen::Vector3d centroid = box.min() + sums.first / sums.weight;
    for_points(scan, i, sizes[i], [&](const Eigen::Vector3d& point, double weight) {
      sums.scatter += weight * (point - centroid) * (point - centroid).transpose();
    });
  }

  ShapeEvaluation out;
  out.planes = static_cast<int>(shapes.size());
  out.diagonal = scan.points.empty() ? 0.0 : box.diagonal().norm();
  out.coverage = all > 0.0 ? covered / all : 0.0;
  double squares = 0.0, weight = 0.0;
  for (const auto& [shape, sums] : shapes) {
    if (sums.weight <= 0.0) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sums.scatter,
                                                                Eigen::EigenvaluesOnly);
    const double own = std::max(0.0, solver.eigenvalues()[0]);
    squares += own;
    weight += sums.weight;
    out.worst_rms = std::max(out.worst_rms, std::sqrt(own / sums.weight));
  }
  if (weight > 0.0) out.rms = std::sqrt(squares / weight);
  return out;
}

double agreement_index(const std::vector<int>& shape_of, const std::vector<int>& truth) {
  CHECK_EQ(shape_of.size(), truth.size());
  std::vector<int> shapes, planes;
  for (size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] < 0) continue;
    shapes.push_back(std::max(shape_of[i], -1));
    planes.push_back(truth[i]);
  }
  return adjusted_rand_index(shapes, planes);
}

}  // namespace gable
