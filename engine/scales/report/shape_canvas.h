#pragma once

#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scales/report/axonometric_view.h>

#include <opencv2/core.hpp>
#include <span>

namespace gable {

/// A picture of shapes in space, nearer ones before farther ones (z-buffer). Surfaces are lit from
/// the upper left of the eye, on both sides.
class ShapeCanvas {
 public:
  /// `view` and the picture are of the same size; edges are smooth.
  explicit ShapeCanvas(const AxonometricView& view);

  /// `shape` from 0 is the colour; -1: none, pale grey.
  void add(const SpacePolygon& polygon, const OrientedPlane& plane, int shape);
  void add_facet(std::span<const Eigen::Vector3d> corners, int shape);
  /// A disc of `radius` pixels, facing the eye; `normal` lights it where it is not zero.
  void add_point(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double radius,
                 int shape);

  /// The picture, 8-bit BGR on white, with dark lines where one shape ends in it if `outlined`.
  cv::Mat picture(bool outlined) const;

 private:
  void fill(std::span<const std::span<const Eigen::Vector3d>> rings, const Eigen::Vector3d& normal,
            int shape);
  uint8_t light(const Eigen::Vector3d& normal) const;

  AxonometricView view_;  ///< of the fine raster
  cv::Mat1f depth_;       ///< metres toward the eye
  cv::Mat1i shape_;       ///< -2: nothing
  cv::Mat1b light_;
};

}  // namespace gable
