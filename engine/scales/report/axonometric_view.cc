#include <gable/engine/scales/report/axonometric_view.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gable {
namespace {

constexpr double kElevation = 35.0 * std::numbers::pi / 180.0;  ///< of the eye
constexpr double kTurn = 30.0 * std::numbers::pi / 180.0;       ///< from the front of a long side
constexpr double kMargin = 0.05;                                ///< of the picture, on every side
constexpr double kOutliers = 0.002;                             ///< share that may fall outside
constexpr size_t kSamples = 100000;

/// Direction of the eye in the plan, anticlockwise from +x: in front of the long side that faces
/// south (or west), and a little to its left.
double azimuth_of(std::span<const Eigen::Vector3d> points, size_t step) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double xx = 0.0, xy = 0.0, yy = 0.0, count = 0.0;
  for (size_t i = 0; i < points.size(); i += step) {
    const Eigen::Vector2d p = (points[i] - points[0]).head<2>();
    sum += p;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
    count += 1.0;
  }
  xx -= sum.x() * sum.x() / count;
  xy -= sum.x() * sum.y() / count;
  yy -= sum.y() * sum.y() / count;
  const double long_axis = 0.5 * std::atan2(2.0 * xy, xx - yy);  // in [-pi / 2, pi / 2]
  return long_axis - std::numbers::pi / 2.0 - kTurn;
}

std::pair<double, double> range(std::vector<double> values) {
  const size_t left_out = static_cast<size_t>(kOutliers * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + left_out, values.end());
  const double low = values[left_out];
  const size_t top = values.size() - 1 - left_out;
  std::nth_element(values.begin(), values.begin() + top, values.end());
  return {low, values[top]};
}

}  // namespace

Eigen::Vector3d AxonometricView::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = point - center;
  return {(width - 1) / 2.0 + pixels_per_meter * right.dot(p),
          (height - 1) / 2.0 - pixels_per_meter * up.dot(p), toward.dot(p)};
}

AxonometricView view_of(std::span<const Eigen::Vector3d> points, int width, int height) {
  CHECK_GE(width, 16);
  CHECK_GE(height, 16);
  AxonometricView view;
  view.width = width;
  view.height = height;
  if (points.empty()) return view;
  const size_t step = points.size() / kSamples + 1;
  const double azimuth = azimuth_of(points, step);
  view.toward = {std::cos(kElevation) * std::cos(azimuth), std::cos(kElevation) * std::sin(azimuth),
                 std::sin(kElevation)};
  view.right = Eigen::Vector3d::UnitZ().cross(view.toward).normalized();
  view.up = view.toward.cross(view.right);
  std::vector<double> xs, ys;
  for (size_t i = 0; i < points.size(); i += step) {
    xs.push_back(view.right.dot(points[i] - points[0]));
    ys.push_back(view.up.dot(points[i] - points[0]));
  }
  const auto [left, right] = range(std::move(xs));
  const auto [bottom, top] = range(std::move(ys));
  view.center = points[0] + (left + right) / 2.0 * view.right + (bottom + top) / 2.0 * view.up;
  const double share = 1.0 - 2.0 * kMargin;
  view.pixels_per_meter =
      share * std::min(width / std::max(right - left, 1e-9), height / std::max(top - bottom, 1e-9));
  return view;
}

AxonometricView resized(const AxonometricView& view, int width, int height) {
  AxonometricView out = view;
  out.width = width;
  out.height = height;
  out.pixels_per_meter *=
      std::min(static_cast<double>(width) / view.width, static_cast<double>(height) / view.height);
  return out;
}

}  // namespace gable
