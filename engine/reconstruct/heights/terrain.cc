#include <gable/engine/error.h>
#include <gable/engine/reconstruct/heights/fill.h>
#include <gable/engine/reconstruct/heights/morphology.h>
#include <gable/engine/reconstruct/heights/terrain.h>
#include <gable/engine/reconstruct/heights/trend.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

namespace gable {
namespace {

constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();
/// Half width of the smallest window, metres.
constexpr double kFirstRadius = 1.0;
/// A cell this much below everything on a ring around it is a false echo, metres.
constexpr double kPitDepth = 1.0;
constexpr double kPitRadius = 1.0;
/// Cells this close to the first terrain are ground after all, metres.
constexpr float kGroundBand = 0.3f;

int cells(double metres, double gsd) {
  return std::max(1, static_cast<int>(std::lround(metres / gsd)));
}

/// Half widths of the windows in cells: doubling up to the widest object.
std::vector<int> window_radii(const TerrainOptions& options, double gsd) {
  const int last = cells(0.5 * options.max_object_width, gsd);
  std::vector<int> radii;
  for (int radius = cells(kFirstRadius, gsd); radius < last; radius *= 2) radii.push_back(radius);
  radii.push_back(last);
  return radii;
}

/// Lowest height on the outline of the square of a radius around a cell; +inf where it has none.
float lowest_on_ring(const HeightRaster& heights, int row, int col, int radius) {
  float lowest = std::numeric_limits<float>::infinity();
  for (int i = -radius; i <= radius; ++i) {
    const int ring[4][2] = {{row - radius, col + i},
                            {row + radius, col + i},
                            {row + i, col - radius},
                            {row + i, col + radius}};
    for (const auto& [r, c] : ring) {
      if (heights.grid.contains(r, c) && heights.at(r, c) < lowest) lowest = heights.at(r, c);
    }
  }
  return lowest;
}

/// Takes out false echoes below the ground, which an opening would keep.
HeightRaster without_pits(const HeightRaster& heights) {
  const int radius = cells(kPitRadius, heights.grid.gsd) + 1;
  const HeightRaster inner_lowest = erode(heights, radius - 1);
  HeightRaster out = heights;
  for (int r = 0; r < heights.grid.rows; ++r) {
    for (int c = 0; c < heights.grid.cols; ++c) {
      if (heights.at(r, c) != inner_lowest.at(r, c)) continue;
      const float ring = lowest_on_ring(heights, r, c, radius);
      if (!std::isfinite(ring) || ring - heights.at(r, c) < kPitDepth) continue;
      for (int i = 1 - radius; i < radius; ++i) {
        for (int j = 1 - radius; j < radius; ++j) {
          if (!heights.grid.contains(r + i, c + j)) continue;
          if (heights.at(r + i, c + j) < ring - 0.5 * kPitDepth) out.at(r + i, c + j) = kNoHeight;
        }
      }
    }
  }
  return out;
}

/// The ground cells of `heights`; NaN elsewhere.
HeightRaster ground_cells(const HeightRaster& heights, const TerrainOptions& options) {
  HeightRaster ground = heights;
  HeightRaster surface = heights;
  int previous = 0;
  for (const int radius : window_radii(options, heights.grid.gsd)) {
    const HeightRaster opened = open(surface, radius);
    const double growth = options.slope * 2.0 * (radius - previous) * heights.grid.gsd;
    const float threshold =
        static_cast<float>(std::min(options.min_object_height + growth, options.max_threshold));
    for (size_t i = 0; i < ground.values.size(); ++i) {
      if (surface.values[i] - opened.values[i] > threshold) ground.values[i] = kNoHeight;
    }
    surface = opened;
    previous = radius;
  }
  return ground;
}

void smooth(double sigma, HeightRaster* heights) {
  if (sigma <= 0.0) return;
  cv::Mat image(heights->grid.rows, heights->grid.cols, CV_32F, heights->values.data());
  cv::Mat smoothed;
  cv::GaussianBlur(image, smoothed, cv::Size(), sigma / heights->grid.gsd, 0.0,
                   cv::BORDER_REPLICATE);
  smoothed.copyTo(image);
}

void require(bool holds, const std::string& bound) {
  if (!holds) throw Error(ExitCode::kUsage, "TerrainOptions: " + bound);
}

}  // namespace

void TerrainOptions::check() const {
  require(max_object_width > 1.0 && max_object_width <= 1000.0,
          "max_object_width must be in (1, 1000] m");
  require(slope >= 0.0 && slope <= 2.0, "slope must be in [0, 2]");
  require(min_object_height > 0.0 && min_object_height <= 5.0,
          "min_object_height must be in (0, 5] m");
  require(max_threshold >= min_object_height, "max_threshold must be at least min_object_height");
  require(smoothing >= 0.0 && smoothing <= 20.0, "smoothing must be in [0, 20] m");
}

HeightRaster derive_terrain(const HeightRaster& dsm, const TerrainOptions& options) {
  options.check();
  const Trend trend(dsm);
  HeightRaster flat = dsm;
  for (int r = 0; r < dsm.grid.rows; ++r) {
    for (int c = 0; c < dsm.grid.cols; ++c) flat.at(r, c) -= static_cast<float>(trend.at(r, c));
  }
  flat = without_pits(flat);
  HeightRaster terrain = fill_smoothly(ground_cells(flat, options));
  // Whatever lies close to this terrain belongs to it, though a window may have cut it off.
  HeightRaster ground = flat;
  for (size_t i = 0; i < ground.values.size(); ++i) {
    if (!(ground.values[i] - terrain.values[i] < kGroundBand)) ground.values[i] = kNoHeight;
  }
  terrain = fill_smoothly(ground);
  smooth(options.smoothing, &terrain);
  for (int r = 0; r < dsm.grid.rows; ++r) {
    for (int c = 0; c < dsm.grid.cols; ++c) {
      const float z = terrain.at(r, c) + static_cast<float>(trend.at(r, c));
      terrain.at(r, c) = dsm.at(r, c) < z ? dsm.at(r, c) : z;
    }
  }
  return terrain;
}

}  // namespace gable
