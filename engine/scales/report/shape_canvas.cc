#include <gable/engine/drawing/canvas.h>
#include <gable/engine/scales/report/shape_canvas.h>
#include <gable/engine/scales/report/shape_colors.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace gable {
namespace {

constexpr int kFine = 2;  ///< fine pixels along the edge of a pixel
constexpr int kNothing = -2;
constexpr double kDarkest = 0.70, kUnlit = 0.92;  ///< light of a surface, of one without a normal
constexpr double kEdgeOn = 1e-3;                  ///< cosine to the eye

Color color_of(int shape) {
  if (shape == kNothing) return kPaperColor;
  return shape < 0 ? kNoShapeColor : shape_color(shape);
}

/// Of any polygon, planar or not (Newell); zero where it has no area.
Eigen::Vector3d normal_of(std::span<const Eigen::Vector3d> corners) {
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();
  for (size_t i = 2; i < corners.size(); ++i) {
    twice += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  }
  return twice.norm() > 0.0 ? twice.normalized() : twice;
}

}  // namespace

ShapeCanvas::ShapeCanvas(const AxonometricView& view)
    : view_(resized(view, kFine * view.width, kFine * view.height)),
      depth_(view_.height, view_.width, -std::numeric_limits<float>::infinity()),
      shape_(view_.height, view_.width, kNothing),
      light_(view_.height, view_.width, static_cast<uint8_t>(255)) {}

uint8_t ShapeCanvas::light(const Eigen::Vector3d& normal) const {
  const double share =
      normal.isZero()
          ? kUnlit
          : kDarkest + (1.0 - kDarkest) *
                           std::max(0.0, (normal.dot(view_.toward) < 0.0 ? -1.0 : 1.0) *
                                             normal.dot((0.9 * view_.toward - 0.55 * view_.right +
                                                         0.5 * Eigen::Vector3d::UnitZ())
                                                            .normalized()));
  return static_cast<uint8_t>(std::lround(255.0 * std::min(share, 1.0)));
}

void ShapeCanvas::fill(std::span<const std::span<const Eigen::Vector3d>> rings,
                       const Eigen::Vector3d& normal, int shape) {
  std::vector<std::vector<Eigen::Vector3d>> seen;
  double low = INFINITY, high = -INFINITY, near = -INFINITY, far = INFINITY;
  for (const auto& ring : rings) {
    std::vector<Eigen::Vector3d>& projected = seen.emplace_back();
    for (const Eigen::Vector3d& p : ring) {
      const Eigen::Vector3d q = projected.emplace_back(view_.project(p));
      low = std::min(low, q.y());
      high = std::max(high, q.y());
      near = std::max(near, q.z());
      far = std::min(far, q.z());
    }
  }
  if (!(low <= high)) return;
  // Depth is linear over the picture: its change per pixel to the right and downwards.
  const double facing = normal.dot(view_.toward);
  double per_column = 0.0, per_row = 0.0;
  if (std::abs(facing) > kEdgeOn) {
    per_column = -normal.dot(view_.right) / facing / view_.pixels_per_meter;
    per_row = normal.dot(view_.up) / facing / view_.pixels_per_meter;
  }
  const Eigen::Vector3d at = seen[0][0];
  const uint8_t lit = light(normal);
  std::vector<double> crossings;
  const int first_row = std::max(0, static_cast<int>(std::ceil(std::max(low, -1.0))));
  const int last_row = static_cast<int>(std::floor(std::min(high, view_.height - 1.0)));
  for (int row = first_row; row <= last_row; ++row) {
    crossings.clear();
    for (const auto& ring : seen) {
      for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const Eigen::Vector3d &a = ring[j], &b = ring[i];
        if ((a.y() > row) == (b.y() > row)) continue;
        crossings.push_back(a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (size_t c = 0; c + 1 < crossings.size(); c += 2) {
      const int first =
          static_cast<int>(std::ceil(std::clamp(crossings[c], 0.0, 1.0 * view_.width)));
      const int last =
          static_cast<int>(std::floor(std::clamp(crossings[c + 1], -1.0, view_.width - 1.0)));
      for (int col = first; col <= last; ++col) {
        const double depth = at.z() + per_column * (col - at.x()) + per_row * (row - at.y());
        const float d = static_cast<float>(std::clamp(depth, far, near));
        if (d <= depth_(row, col)) continue;
        depth_(row, col) = d;
        shape_(row, col) = shape;
        light_(row, col) = lit;
      }
    }
  }
}

void ShapeCanvas::add(const SpacePolygon& polygon, const OrientedPlane& plane, int shape) {
  std::vector<std::span<const Eigen::Vector3d>> rings{polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  fill(rings, plane.normal(), shape);
}

void ShapeCanvas::add_facet(std::span<const Eigen::Vector3d> corners, int shape) {
  fill(std::vector{corners}, normal_of(corners), shape);
}

void ShapeCanvas::add_point(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                            double radius, int shape) {
  const Eigen::Vector3d q = view_.project(point);
  const double r = kFine * radius;
  if (!(q.x() > -r && q.x() < view_.width + r && q.y() > -r && q.y() < view_.height + r)) return;
  const float d = static_cast<float>(q.z());
  const uint8_t lit = light(normal);
  const int center_row = static_cast<int>(std::lround(q.y()));
  const int center_col = static_cast<int>(std::lround(q.x()));
  const int reach = static_cast<int>(r);
  for (int row = std::max(0, center_row - reach);
       row <= std::min(view_.height - 1, center_row + reach); ++row) {
    const double across = std::sqrt(std::max(0.0, r * r - std::pow(row - center_row, 2)));
    const int half = static_cast<int>(across);
    for (int col = std::max(0, center_col - half);
         col <= std::min(view_.width - 1, center_col + half); ++col) {
      if (d <= depth_(row, col)) continue;
      depth_(row, col) = d;
      shape_(row, col) = shape;
      light_(row, col) = lit;
    }
  }
}

cv::Mat ShapeCanvas::picture(bool outlined) const {
  cv::Mat3b fine(shape_.size(), bgr(kPaperColor));
  for (int row = 0; row < fine.rows; ++row) {
    for (int col = 0; col < fine.cols; ++col) {
      const int shape = shape_(row, col);
      const int right = shape_(row, std::min(col + 1, fine.cols - 1));
      const int below = shape_(std::min(row + 1, fine.rows - 1), col);
      if (outlined && (shape != right || shape != below)) {
        fine(row, col) = bgr(kInkColor);
      } else if (shape != kNothing) {
        fine(row, col) = bgr(mix({0, 0, 0}, color_of(shape), light_(row, col) / 255.0));
      }
    }
  }
  cv::Mat out;
  cv::resize(fine, out, {view_.width / kFine, view_.height / kFine}, 0, 0, cv::INTER_AREA);
  return out;
}

}  // namespace gable
