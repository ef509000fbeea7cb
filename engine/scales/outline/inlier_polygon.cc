#include <gable/engine/scales/outline/inlier_polygon.h>
#include <gable/engine/scales/outline/plane_frame.h>
#include <gable/engine/scales/outline/polygon_raster.h>
#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace gable {
namespace {

constexpr double kAlphaSpacings = 2.5;
constexpr double kAlphaPixels = 4.5;  ///< half an odd number: exact along the axes
/// Pixels: a point stands for half a spacing on each side of it.
constexpr double kInset = -0.5 * kAlphaPixels / kAlphaSpacings;
constexpr double kTolerance = 0.8;  ///< pixels
constexpr double kMaxPixels = 2000.0;
constexpr int kSpacingSamples = 200, kSpacingNeighbour = 8;

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
  PolygonRaster raster(flat, kAlphaSpacings * spacing / kAlphaPixels, kMaxPixels, kAlphaPixels);
  for (const Eigen::Vector2d& p : flat) {
    const Eigen::Vector2d q = raster.pixel(p);
    raster.mask.at<uint8_t>(static_cast<int>(std::lround(q.y())),
                            static_cast<int>(std::lround(q.x()))) = 255;
  }
  return lifted(raster.outlines(kInset, kTolerance), frame);
}

double planar_spacing(std::span<const Eigen::Vector3d> points, const OrientedPlane& plane) {
  if (points.size() < 3) return 0.0;
  return spacing_of(projected(points, PlaneFrame(plane, points[0])));
}

}  // namespace gable
