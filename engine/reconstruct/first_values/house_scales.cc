#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gable/engine/reconstruct/heights/raster_noise.h>
#include <gable/engine/scales/cheapest_configuration.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/scale_chain.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

// Fewest pixels of a plane, whatever their size.
constexpr int kFewestPixels = 5;

bool is_seen(const HeightImage& image, int row, int col) {
  const size_t i = image.index(row, col);
  return image.inside[i] && is_evidence(image, i);
}

struct PixelCloud {
  Scan scan;
  std::vector<int> pixels;  // per point
  int stride = 1;
};

PixelCloud cloud_of(const HeightImage& image, int most_points) {
  int count = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) count += is_seen(image, row, col);
  }
  PixelCloud cloud;
  while (count / (cloud.stride * cloud.stride) > most_points) ++cloud.stride;
  for (int row = 0; row < image.rows; row += cloud.stride) {
    for (int col = 0; col < image.cols; col += cloud.stride) {
      if (!is_seen(image, row, col)) continue;
      const size_t i = image.index(row, col);
      const Eigen::Vector2d p = image.center_of(row, col);
      cloud.scan.points.emplace_back(p.x(), p.y(), image.height[i]);
      cloud.pixels.push_back(static_cast<int>(i));
    }
  }
  return cloud;
}

std::array<int, 3> labelled_configurations(const Trajectory& trajectory, const ScaleModel& model) {
  const ScaleLabels labels = label_trajectory(trajectory.features, model.forest, {model.gamma});
  std::array<int, 3> out{};
  const int last = labels.num_scales() - 1;
  const std::array<int, 3> picked = {0, (last + 1) / 2, last};
  for (size_t s = 0; s < out.size(); ++s) {
    out[s] = std::min(labels.first[picked[s]], trajectory.num_configurations() - 1);
  }
  return out;
}

HouseScale scale_at(const HeightImage& image, const PixelCloud& cloud,
                    const CollapsedScan& collapsed, int configuration,
                    const HouseScalesOptions& options) {
  DetectScalesOptions detect;
  detect.refit = options.refit;
  detect.polygons = false;
  const ScaleShapes shapes =
      shapes_of_configuration(cloud.scan, collapsed, configuration, detect, nullptr);
  HouseScale scale;
  scale.configuration = configuration;
  std::vector<HousePlane> planes(shapes.shapes.size());
  for (size_t i = 0; i < cloud.pixels.size(); ++i) {
    if (shapes.shape_of[i] >= 0) planes[shapes.shape_of[i]].pixels.push_back(cloud.pixels[i]);
  }
  size_t covered = 0;
  for (size_t s = 0; s < planes.size(); ++s) {
    const OrientedPlane& oriented = shapes.shapes[s].plane;
    const Eigen::Vector3d normal = oriented.normal();
    if (std::abs(normal.z()) * std::hypot(1.0, options.steepest) < 1.0) continue;
    HousePlane& plane = planes[s];
    plane.plane = {-normal.x() / normal.z(), -normal.y() / normal.z(),
                   oriented.offset() / normal.z()};
    double squares = 0.0;
    for (int pixel : plane.pixels) {
      const Eigen::Vector2d p = image.center_of(pixel / image.cols, pixel % image.cols);
      const double d = image.height[pixel] - plane.plane.at(p);
      squares += d * d;
      plane.centroid += p;
    }
    const double n = static_cast<double>(plane.pixels.size());
    plane.centroid /= n;
    plane.rms = std::sqrt(squares / n);
    covered += plane.pixels.size();
    scale.planes.push_back(std::move(plane));
  }
  std::stable_sort(
      scale.planes.begin(), scale.planes.end(),
      [](const HousePlane& a, const HousePlane& b) { return a.pixels.size() > b.pixels.size(); });
  scale.coverage = static_cast<double>(covered) /
                   std::max<double>(1.0, static_cast<double>(cloud.pixels.size()));
  return scale;
}

}  // namespace

std::string check(const HouseScalesOptions& options) {
  if (options.neighbours < 4 || options.neighbours > 50) return "neighbours must lie in [4, 50]";
  if (!(options.max_angle > 0.0 && options.max_angle < 1.5708)) {
    return "max_angle must lie in (0, 1.5708)";
  }
  if (!(options.least_area > 0.0)) return "least_area must be positive";
  if (!(options.epsilon_deviations >= 1.0 && options.epsilon_deviations <= 10.0)) {
    return "epsilon_deviations must lie in [1, 10]";
  }
  if (!(options.least_noise > 0.0)) return "least_noise must be positive";
  if (!(options.most_noise >= options.least_noise)) return "most_noise is below least_noise";
  if (!(options.roof_deviation > 0.0)) return "roof_deviation must be positive";
  if (!(options.block_deviation > 0.0)) return "block_deviation must be positive";
  if (options.most_points < 100 || options.most_points > 1000000) {
    return "most_points must lie in [100, 1000000]";
  }
  if (!(options.steepest > 0.0)) return "steepest must be positive";
  return check(options.refit);
}

HouseScales house_scales(const HeightImage& image, const ScaleModel* model,
                         const HouseScalesOptions& options) {
  CHECK(check(options).empty()) << check(options);
  HouseScales out;
  out.noise = std::clamp(raster_noise(image), options.least_noise, options.most_noise);
  const PixelCloud cloud = cloud_of(image, options.most_points);
  out.stride = cloud.stride;
  out.num_points = static_cast<int>(cloud.pixels.size());
  if (cloud.pixels.size() < 4) return out;

  const double cell = image.gsd * cloud.stride;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : cloud.scan.points) box.extend(p);
  FirstShapesOptions first;
  first.neighbours = options.neighbours;
  first.max_angle = options.max_angle;
  first.min_inliers =
      std::max(kFewestPixels, static_cast<int>(std::ceil(options.least_area / (cell * cell))));
  // The noise is known better from the raster than from the neighbourhoods of a small cloud, which
  // reach over its ridges.
  first.epsilon_deviations = 0.0;
  first.epsilon_percent =
      std::min(10.0, 100.0 * options.epsilon_deviations * out.noise / box.diagonal().norm());
  const CollapsedScan collapsed = collapse_scan(cloud.scan, first);
  out.num_first = collapsed.trajectory.num_first;
  if (out.num_first == 0) return out;

  std::array<int, 3> configurations{};
  if (model != nullptr) {
    configurations = labelled_configurations(collapsed.trajectory, *model);
  } else {
    const std::array<double, 3> deviations = {out.noise,
                                              std::max(out.noise, options.roof_deviation),
                                              std::max(out.noise, options.block_deviation)};
    for (size_t s = 0; s < deviations.size(); ++s) {
      configurations[s] = cheapest_configuration(cloud.scan.points, collapsed, deviations[s]);
    }
  }
  for (size_t s = 0; s < configurations.size(); ++s) {
    const bool known = s > 0 && configurations[s] == configurations[s - 1];
    out.scales[s] =
        known ? out.scales[s - 1] : scale_at(image, cloud, collapsed, configurations[s], options);
  }
  return out;
}

}  // namespace gable
