#include <gable/engine/scales/report/configuration_picture.h>
#include <gable/engine/scales/report/shape_canvas.h>
#include <gable/residuals/point_moments.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kMinRadius = 0.5, kMaxRadius = 6.0;  ///< pixels
/// Of a picture that a scan covers, and of its points that are in front.
constexpr double kCovered = 0.4, kInFront = 0.5;

/// Discs that just close up where points lie evenly.
double disc_radius(size_t num_points, const AxonometricView& view) {
  const double pixels_per_point = kCovered * view.width * view.height /
                                  (kInFront * static_cast<double>(std::max<size_t>(num_points, 1)));
  return std::clamp(0.9 * std::sqrt(pixels_per_point), kMinRadius, kMaxRadius);
}

/// The normal of the plane through each shape's points, towards any side; zero for a single point.
std::vector<Eigen::Vector3d> shape_normals(const Scan& scan, std::span<const int> shape_of) {
  std::vector<PointMoments> moments;
  for (size_t i = 0; i < shape_of.size(); ++i) {
    if (shape_of[i] < 0) continue;
    if (shape_of[i] >= static_cast<int>(moments.size())) {
      moments.resize(shape_of[i] + 1, PointMoments{.reference = scan.points[0]});
    }
    moments[shape_of[i]].add(scan.points[i]);
  }
  std::vector<Eigen::Vector3d> normals;
  for (const PointMoments& m : moments) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (m.weight >= 3.0) {
      normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m.scatter()).eigenvectors().col(0);
    }
    normals.push_back(normal);
  }
  return normals;
}

void add_facets(const Scan& mesh, std::span<const int> shape_of, ShapeCanvas& canvas) {
  std::vector<Eigen::Vector3d> corners;
  for (size_t f = 0; f < mesh.facets.size(); ++f) {
    corners.clear();
    for (const int corner : mesh.facets[f]) corners.push_back(mesh.points[corner]);
    canvas.add_facet(corners, shape_of[f]);
  }
}

}  // namespace

cv::Mat draw_shapes(std::span<const PlanarShape> shapes, const AxonometricView& view,
                    std::span<const int> numbers) {
  CHECK(numbers.empty() || numbers.size() == shapes.size());
  ShapeCanvas canvas(view);
  for (size_t s = 0; s < shapes.size(); ++s) {
    const int number = numbers.empty() ? static_cast<int>(s) : numbers[s];
    for (const SpacePolygon& polygon : shapes[s].polygons) {
      canvas.add(polygon, shapes[s].plane, number);
    }
  }
  return canvas.picture(true);
}

cv::Mat draw_elements(const Scan& scan, std::span<const int> shape_of,
                      const AxonometricView& view) {
  CHECK_EQ(shape_of.size(), scan.num_elements());
  ShapeCanvas canvas(view);
  if (scan.is_mesh()) {
    add_facets(scan, shape_of, canvas);
    return canvas.picture(true);
  }
  const std::vector<Eigen::Vector3d> normals = shape_normals(scan, shape_of);
  const double radius = disc_radius(scan.points.size(), view);
  for (size_t i = 0; i < scan.points.size(); ++i) {
    const int shape = shape_of[i];
    canvas.add_point(scan.points[i], shape < 0 ? Eigen::Vector3d::Zero() : normals[shape],
                     shape < 0 ? std::max(kMinRadius, radius / 3.0) : radius, shape);
  }
  return canvas.picture(false);
}

cv::Mat draw_scan(const Scan& scan, const AxonometricView& view) {
  ShapeCanvas canvas(view);
  if (scan.is_mesh()) {
    add_facets(scan, std::vector(scan.facets.size(), -1), canvas);
    return canvas.picture(false);
  }
  const double radius = disc_radius(scan.points.size(), view);
  for (size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d normal =
        scan.normals.empty() ? Eigen::Vector3d::Zero() : scan.normals[i].cast<double>().eval();
    canvas.add_point(scan.points[i], normal, radius, -1);
  }
  return canvas.picture(false);
}

}  // namespace gable
