#include <gable/engine/scales/outline/facet_boundary.h>
#include <gable/engine/scales/outline/facet_polygon.h>
#include <gable/engine/scales/outline/polygon_raster.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

constexpr double kAlphaPixels = 1.5;  ///< closes cracks
constexpr double kTolerance = 0.9;    ///< pixels
constexpr double kPixelsPerFacet = 40.0, kMinPixels = 200.0, kMaxPixels = 600.0;
constexpr int kSubpixelBits = 6;

std::vector<OutlinedRegion> rasterised(const std::vector<Ring>& facets) {
  std::vector<Eigen::Vector2d> corners;
  for (const Ring& facet : facets) corners.insert(corners.end(), facet.begin(), facet.end());
  const double pixels = std::clamp(kPixelsPerFacet * std::sqrt(static_cast<double>(facets.size())),
                                   kMinPixels, kMaxPixels);
  PolygonRaster raster(corners, 0.0, pixels, kAlphaPixels);
  std::vector<cv::Point> filled;
  for (const Ring& facet : facets) {
    filled.clear();
    for (const Eigen::Vector2d& p : facet) {
      const Eigen::Vector2d q = raster.pixel(p) * (1 << kSubpixelBits);
      filled.emplace_back(static_cast<int>(std::lround(q.x())),
                          static_cast<int>(std::lround(q.y())));
    }
    cv::fillPoly(raster.mask, std::vector{filled}, cv::Scalar(255), cv::LINE_8, kSubpixelBits);
  }
  return raster.outlines(0.0, kTolerance);
}

}  // namespace

std::vector<SpacePolygon> facet_polygons(const Scan& mesh, std::span<const int> facets,
                                         const OrientedPlane& plane) {
  std::vector<Ring> flat;
  if (facets.empty()) return {};
  const PlaneFrame frame(plane, mesh.points[mesh.facets[facets[0]][0]]);
  for (const int facet : facets) {
    Ring ring;
    for (const int corner : mesh.facets[facet]) ring.push_back(frame.project(mesh.points[corner]));
    if (ring.size() >= 3) flat.push_back(std::move(ring));
  }
  if (flat.empty()) return {};
  if (auto exact = union_by_boundary(flat)) return lifted(std::move(*exact), frame);
  return lifted(rasterised(flat), frame);
}

}  // namespace gable
