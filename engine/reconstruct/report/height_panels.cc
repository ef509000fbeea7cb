#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/color.h>
#include <gable/engine/reconstruct/report/height_panels.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// How much of a colour's brightness the shading may take.
constexpr double kShadeDepth = 0.35;

template <typename ColorOfCell>
cv::Mat paint(const HeightImage& image, const PanelScale& scale, const ColorOfCell& color_of_cell) {
  cv::Mat panel(scale.height, scale.width, CV_8UC3);
  for (int y = 0; y < panel.rows; ++y) {
    const int row = scale.row_of(y, image);
    for (int x = 0; x < panel.cols; ++x) {
      panel.at<cv::Vec3b>(y, x) = bgr(color_of_cell(row, scale.col_of(x, image)));
    }
  }
  return panel;
}

}  // namespace

PanelScale::PanelScale(const HeightImage& image, int panel_size) {
  const int longest = std::max({image.rows, image.cols, 1});
  pixels_per_cell =
      longest <= panel_size ? panel_size / longest : static_cast<double>(panel_size) / longest;
  width = std::max(1, static_cast<int>(image.cols * pixels_per_cell));
  height = std::max(1, static_cast<int>(image.rows * pixels_per_cell));
}

int PanelScale::row_of(int y, const HeightImage& image) const {
  return std::min(static_cast<int>((y + 0.5) / pixels_per_cell), image.rows - 1);
}

int PanelScale::col_of(int x, const HeightImage& image) const {
  return std::min(static_cast<int>((x + 0.5) / pixels_per_cell), image.cols - 1);
}

std::vector<float> model_heights(const BuildingSurface& surface, const HeightImage& image) {
  std::vector<float> heights(image.size());
  const double support = std::max(image.gsd, image.spread);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      heights[i] =
          static_cast<float>(surface.height(image.center_of(row, col), support, image.ground[i]));
    }
  }
  return heights;
}

bool is_measured(const HeightImage& image, size_t index) {
  return image.weight[index] > 0.0f && std::isfinite(image.height[index]);
}

HeightRange shown_range(const HeightImage& image, const std::vector<float>& model) {
  std::vector<float> measured;
  for (size_t i = 0; i < image.size(); ++i) {
    if (is_measured(image, i)) measured.push_back(image.height[i]);
  }
  std::sort(measured.begin(), measured.end());
  HeightRange range{INFINITY, -INFINITY};
  if (!measured.empty()) {
    const size_t cut = measured.size() / 200;
    range = {measured[cut], measured[measured.size() - 1 - cut]};
  }
  for (const float height : model) {
    if (!std::isfinite(height)) continue;
    range.low = std::min<double>(range.low, height);
    range.high = std::max<double>(range.high, height);
  }
  if (!std::isfinite(range.low)) return {0.0, 1.0};
  if (range.high - range.low < 1.0) range.high = range.low + 1.0;
  return range;
}

double shade(const HeightImage& image, const std::vector<float>& heights, int row, int col) {
  const int west = std::max(col - 1, 0), east = std::min(col + 1, image.cols - 1);
  const int north = std::max(row - 1, 0), south = std::min(row + 1, image.rows - 1);
  const double run_x = std::max(east - west, 1) * image.gsd;
  const double run_y = std::max(south - north, 1) * image.gsd;
  double slope_x = (heights[image.index(row, east)] - heights[image.index(row, west)]) / run_x;
  double slope_y = (heights[image.index(north, col)] - heights[image.index(south, col)]) / run_y;
  if (!std::isfinite(slope_x)) slope_x = 0.0;
  if (!std::isfinite(slope_y)) slope_y = 0.0;
  // The light stands 45 degrees above the north-western horizon: direction (-1, 1, sqrt 2) / 2.
  const double toward_light = slope_x - slope_y + std::sqrt(2.0);
  return std::clamp(0.5 * toward_light / std::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0),
                    0.0, 1.0);
}

cv::Mat height_panel(const HeightImage& image, const std::vector<float>& heights,
                     const HeightRange& range, bool measured_only, const PanelScale& scale) {
  const double level_shade = std::sqrt(0.5);
  return paint(image, scale, [&](int row, int col) {
    const size_t i = image.index(row, col);
    if (!std::isfinite(heights[i]) || (measured_only && !is_measured(image, i))) {
      return kNoDataColor;
    }
    const Color color = height_color((heights[i] - range.low) / (range.high - range.low));
    // Level ground keeps its colour, so that the colour bar holds for it.
    const double light = shade(image, heights, row, col) - level_shade;
    return light < 0.0 ? mix(color, {0, 0, 0}, -light * kShadeDepth / level_shade)
                       : mix(color, {255, 255, 255}, light * kShadeDepth / (1.0 - level_shade));
  });
}

cv::Mat residual_panel(const HeightImage& image, const std::vector<float>& model, double range,
                       const PanelScale& scale) {
  return paint(image, scale, [&](int row, int col) {
    const size_t i = image.index(row, col);
    if (!is_measured(image, i) || !std::isfinite(model[i])) return kNoDataColor;
    return residual_color((image.height[i] - model[i]) / range);
  });
}

}  // namespace gable
