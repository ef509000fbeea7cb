#include <gable/engine/scales/outline/polygon_raster.h>
#include <gable/engine/scales/outline/raster_outline.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gable {

PolygonRaster::PolygonRaster(std::span<const Eigen::Vector2d> points, double cell,
                             double max_pixels, double radius)
    : radius_(radius), margin_(static_cast<int>(std::ceil(radius)) + 3) {
  CHECK(!points.empty());
  corner_ = points[0];
  Eigen::Vector2d top = points[0];
  for (const Eigen::Vector2d& p : points) {
    corner_ = corner_.cwiseMin(p);
    top = top.cwiseMax(p);
  }
  const Eigen::Vector2d extent = top - corner_;
  cell_ = std::max(cell, extent.maxCoeff() / max_pixels);
  if (!(cell_ > 0.0)) cell_ = 1.0;
  const Eigen::Vector2d size = extent / cell_;
  mask = cv::Mat::zeros(static_cast<int>(size.y()) + 2 * margin_ + 2,
                        static_cast<int>(size.x()) + 2 * margin_ + 2, CV_8U);
}

std::vector<OutlinedRegion> PolygonRaster::outlines(double inset, double tolerance) const {
  std::vector<OutlinedRegion> regions = outlines_of_closing(mask, radius_, inset, tolerance);
  const auto scale = [this](Ring& ring) {
    for (Eigen::Vector2d& q : ring) {
      q = (q - Eigen::Vector2d::Constant(margin_)) * cell_ + corner_;
    }
  };
  for (OutlinedRegion& region : regions) {
    scale(region.outer);
    for (Ring& hole : region.holes) scale(hole);
    region.area *= cell_ * cell_;
  }
  return regions;
}

}  // namespace gable
