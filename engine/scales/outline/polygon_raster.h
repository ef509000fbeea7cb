#pragma once

#include <gable/engine/scales/outline/outlined_region.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace gable {

/// A raster over points of a plane, to mark what is to be outlined.
class PolygonRaster {
 public:
  /// Cells of `cell` (the points' unit), or as many times larger as keeps the longer side within
  /// `max_pixels`; around the points there is room for a closing by `radius` pixels.
  PolygonRaster(std::span<const Eigen::Vector2d> points, double cell, double max_pixels,
                double radius);

  /// Column and row of a point, not rounded.
  Eigen::Vector2d pixel(const Eigen::Vector2d& point) const {
    return (point - corner_) / cell_ + Eigen::Vector2d::Constant(margin_);
  }

  /// Outlines of the marks, see `outlines_of_closing` (its arguments in pixels).
  std::vector<OutlinedRegion> outlines(double inset, double tolerance) const;

  cv::Mat mask;  ///< 8-bit, marks are not 0

 private:
  Eigen::Vector2d corner_;
  double cell_;
  double radius_;
  int margin_;
};

}  // namespace gable
