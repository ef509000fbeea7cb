#include <gable/engine/scales/inlier_polygon.h>
#include <gable/engine/scales/plane_frame.h>
#include <gable/engine/scales/raster_outline.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace gable {
namespace {

constexpr double kAlphaSpacings = 2.5;
/// Pixels: half an odd number, so that the closing is exact along the axes.
constexpr double kAlphaPixels = 4.5, kFacetAlphaPixels = 1.5;
/// Pixels: a point stands for half a spacing on each side of it.
constexpr double kPointInset = -0.5 * kAlphaPixels / kAlphaSpacings;
/// Pixels: filled facets hold every pixel that their outline touches.
constexpr double kFacetInset = 0.4;
constexpr double kPointTolerance = 0.8, kFacetTolerance = 0.9;  ///< pixels
constexpr double kMaxPointPixels = 2000.0, kFacetPixels = 1000.0;
constexpr int kSpacingSamples = 200, kSpacingNeighbour = 8;
constexpr int kSubpixelBits = 6;

std::vector<Eigen::Vector2d> projected(std::span<const Eigen::Vector3d> points,
                                       const PlaneFrame& frame) {
  std::vector<Eigen::Vector2d> out;
  out.reserve(points.size());
  for (const Eigen::Vector3d& p : points) out.push_back(frame.project(p));
  return out;
}

/// Squared distance to the `count`-th nearest of the other points, 1 to kSpacingNeighbour.
double squared_distance_to_neighbour(const std::vector<Eigen::Vector2d>& points, size_t of,
                                     int count) {
  std::array<double, kSpacingNeighbour> nearest;
  nearest.fill(std::numeric_limits<double>::infinity());
  double& farthest = nearest[count - 1];
  for (size_t i = 0; i < points.size(); ++i) {
    const double squared = (points[i] - points[of]).squaredNorm();
    if (squared >= farthest || i == of) continue;
    farthest = squared;
    for (int k = count - 1; k > 0 && nearest[k] < nearest[k - 1]; --k) {
      std::swap(nearest[k], nearest[k - 1]);
    }
  }
  return farthest;
}

double spacing_of(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return 0.0;
  const int neighbour = static_cast<int>(std::min<size_t>(kSpacingNeighbour, points.size() - 1));
  const size_t samples = std::min<size_t>(kSpacingSamples, points.size());
  std::vector<double> spacings;
  for (size_t s = 0; s < samples; ++s) {
    const double squared =
        squared_distance_to_neighbour(points, s * points.size() / samples, neighbour);
    // A disc to the k-th neighbour holds k other points.
    spacings.push_back(std::sqrt(squared * std::numbers::pi / neighbour));
  }
  const auto quartile = spacings.begin() + spacings.size() * 3 / 4;
  std::nth_element(spacings.begin(), quartile, spacings.end());
  return *quartile;
}

/// A raster over points: pixel = (point - corner) / cell + margin.
struct Grid {
  Eigen::Vector2d corner;
  double cell = 1.0;
  int margin = 0;
  cv::Mat mask;

  Grid(const std::vector<Eigen::Vector2d>& points, double wanted_cell, double max_pixels,
       double radius_pixels)
      : margin(static_cast<int>(std::ceil(radius_pixels)) + 3) {
    corner = points[0];
    Eigen::Vector2d top = points[0];
    for (const Eigen::Vector2d& p : points) {
      corner = corner.cwiseMin(p);
      top = top.cwiseMax(p);
    }
    const Eigen::Vector2d extent = top - corner;
    cell = std::max(wanted_cell, extent.maxCoeff() / max_pixels);
    const Eigen::Vector2d size = extent / cell;
    mask = cv::Mat::zeros(static_cast<int>(size.y()) + 2 * margin + 2,
                          static_cast<int>(size.x()) + 2 * margin + 2, CV_8U);
  }

  Eigen::Vector2d pixel(const Eigen::Vector2d& p) const {
    return (p - corner) / cell + Eigen::Vector2d::Constant(margin);
  }
  Eigen::Vector2d point(const Eigen::Vector2d& pixel) const {
    return (pixel - Eigen::Vector2d::Constant(margin)) * cell + corner;
  }
};

std::vector<SpacePolygon> lifted(std::vector<OutlinedRegion> regions, const Grid& grid,
                                 const PlaneFrame& frame) {
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return a.area > b.area; });
  const auto lift = [&](const Ring& ring) {
    std::vector<Eigen::Vector3d> out;
    for (const Eigen::Vector2d& q : ring) out.push_back(frame.lift(grid.point(q)));
    return out;
  };
  std::vector<SpacePolygon> polygons;
  for (const OutlinedRegion& region : regions) {
    SpacePolygon& polygon = polygons.emplace_back();
    polygon.outer = lift(region.outer);
    for (const Ring& hole : region.holes) polygon.holes.push_back(lift(hole));
  }
  return polygons;
}

}  // namespace

std::string check(const InlierPolygonOptions& options) {
  if (!(options.spacing >= 0.0 && options.spacing <= 1e6)) return "spacing must be in [0, 1e6]";
  return "";
}

std::vector<SpacePolygon> inlier_polygons(std::span<const Eigen::Vector3d> points,
                                          const OrientedPlane& plane,
                                          const InlierPolygonOptions& options) {
  CHECK(check(options).empty()) << check(options);
  if (points.size() < 3) return {};
  const PlaneFrame frame(plane, points[0]);
  const std::vector<Eigen::Vector2d> flat = projected(points, frame);
  const double spacing = options.spacing > 0.0 ? options.spacing : spacing_of(flat);
  if (!(spacing > 0.0)) return {};
  Grid grid(flat, kAlphaSpacings * spacing / kAlphaPixels, kMaxPointPixels, kAlphaPixels);
  for (const Eigen::Vector2d& p : flat) {
    const Eigen::Vector2d q = grid.pixel(p);
    grid.mask.at<uint8_t>(static_cast<int>(std::lround(q.y())),
                          static_cast<int>(std::lround(q.x()))) = 255;
  }
  return lifted(outlines_of_closing(grid.mask, kAlphaPixels, kPointInset, kPointTolerance), grid,
                frame);
}

std::vector<SpacePolygon> facet_polygons(const Scan& mesh, std::span<const int> facets,
                                         const OrientedPlane& plane) {
  std::vector<Eigen::Vector3d> corners;
  for (const int facet : facets) {
    for (const int corner : mesh.facets[facet]) corners.push_back(mesh.points[corner]);
  }
  if (corners.size() < 3) return {};
  const PlaneFrame frame(plane, corners[0]);
  const std::vector<Eigen::Vector2d> flat = projected(corners, frame);
  Grid grid(flat, 1e-9, kFacetPixels, kFacetAlphaPixels);
  std::vector<cv::Point> ring;
  size_t next = 0;
  for (const int facet : facets) {
    ring.clear();
    for (size_t i = 0; i < mesh.facets[facet].size(); ++i) {
      const Eigen::Vector2d q = grid.pixel(flat[next++]) * (1 << kSubpixelBits);
      ring.emplace_back(static_cast<int>(std::lround(q.x())), static_cast<int>(std::lround(q.y())));
    }
    if (ring.size() < 3) continue;
    cv::fillPoly(grid.mask, std::vector{ring}, cv::Scalar(255), cv::LINE_8, kSubpixelBits);
  }
  return lifted(outlines_of_closing(grid.mask, kFacetAlphaPixels, kFacetInset, kFacetTolerance),
                grid, frame);
}

double area_of(const SpacePolygon& polygon) {
  const auto ring_area = [](const std::vector<Eigen::Vector3d>& ring) {
    Eigen::Vector3d twice = Eigen::Vector3d::Zero();
    for (size_t i = 2; i < ring.size(); ++i) {
      twice += (ring[i - 1] - ring[0]).cross(ring[i] - ring[0]);
    }
    return twice.norm() / 2.0;
  };
  double area = ring_area(polygon.outer);
  for (const auto& hole : polygon.holes) area -= ring_area(hole);
  return area;
}

double planar_spacing(std::span<const Eigen::Vector3d> points, const OrientedPlane& plane) {
  if (points.size() < 3) return 0.0;
  return spacing_of(projected(points, PlaneFrame(plane, points[0])));
}

}  // namespace gable
