#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/fixed.h>
#include <gable/engine/reconstruct/annotate/annotated_from_answer.h>
#include <gable/engine/reconstruct/annotate/annotation_panel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace gable {
namespace {

constexpr int kScale = 6;  // panel pixels to one of the crop
constexpr int kSide = kCropSize * kScale;
constexpr int kLeft = 26, kTop = 38, kBottom = 26, kGap = 10;
constexpr int kTickStep = 8;  // crop pixels

// The darkest reds are left out: what stands out above the rest of a roof keeps its contrast.
constexpr double kTopShare = 0.88;

constexpr Color kOutlineColor{255, 255, 255};
constexpr Color kGarageColor{255, 120, 255};
constexpr Color kDormerColor{255, 255, 60};
constexpr Color kChimneyColor{255, 60, 60};

/// Bilinear between the cell centres; NaN where one of the four has no height.
double height_at(const HeightRaster& dsm, const Eigen::Vector2d& world) {
  const Eigen::Vector2d cell = dsm.grid.cell_of(world);
  const int row = static_cast<int>(std::floor(cell.x())),
            col = static_cast<int>(std::floor(cell.y()));
  if (!dsm.grid.contains(row, col) || !dsm.grid.contains(row + 1, col + 1)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double v = cell.x() - row, u = cell.y() - col;
  return (1.0 - v) * ((1.0 - u) * dsm.at(row, col) + u * dsm.at(row, col + 1)) +
         v * ((1.0 - u) * dsm.at(row + 1, col) + u * dsm.at(row + 1, col + 1));
}

/// Heights over the datum and their slopes, at the pixels of a panel.
struct Samples {
  cv::Mat1d height = cv::Mat1d(kSide, kSide);
  cv::Mat1d slope_x = cv::Mat1d(kSide, kSide);  ///< rise to the right, metres a metre
  cv::Mat1d slope_y = cv::Mat1d(kSide, kSide);  ///< rise to the top
  double top = 3.0;                             ///< what the strongest colour stands for, metres
};

Eigen::Vector2d crop_of_pixel(int row, int col) {
  return {(col + 0.5) / kScale, (row + 0.5) / kScale};
}

Samples sample(const AnnotationPanelInput& input) {
  const CropFrame& frame = input.answer->frame;
  const HeightRaster& dsm = *input.dsm;
  // Differences over a cell: what is finer than that, interpolation made.
  const double step = 0.5 * dsm.grid.gsd;
  const Eigen::Vector2d right = Eigen::Rotation2Dd(frame.azimuth) * Eigen::Vector2d(step, 0.0);
  const Eigen::Vector2d up(-right.y(), right.x());
  Samples samples;
  std::vector<double> heights;
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const Eigen::Vector2d p = frame.world_from_crop(crop_of_pixel(row, col));
      const double z = height_at(dsm, p) - input.datum;
      samples.height(row, col) = z;
      samples.slope_x(row, col) =
          (height_at(dsm, p + right) - height_at(dsm, p - right)) / (2.0 * step);
      samples.slope_y(row, col) = (height_at(dsm, p + up) - height_at(dsm, p - up)) / (2.0 * step);
      const bool middle = std::min({row, col, kSide - 1 - row, kSide - 1 - col}) > kSide / 7;
      if (middle && std::isfinite(z)) heights.push_back(z);
    }
  }
  if (!heights.empty()) {
    const auto high = heights.begin() + static_cast<long>(0.995 * (heights.size() - 1));
    std::nth_element(heights.begin(), high, heights.end());
    samples.top = std::max(samples.top, *high);
  }
  return samples;
}

/// Lines of equal height, one a metre and fainter ones between.
void draw_contours(const Samples& samples, cv::Mat* colors) {
  const auto level = [&](int row, int col, double step) {
    return std::floor(samples.height(row, col) / step);
  };
  for (const double step : {0.5, 1.0}) {
    for (int row = 0; row + 1 < kSide; ++row) {
      for (int col = 0; col + 1 < kSide; ++col) {
        const double here = level(row, col, step);
        // Walls are no slopes: their lines would lie on each other.
        if (!(std::hypot(samples.slope_x(row, col), samples.slope_y(row, col)) < 2.0)) continue;
        if (!(here >= 2.0) ||
            (here == level(row, col + 1, step) && here == level(row + 1, col, step)))
          continue;
        cv::Vec3b& color = colors->at<cv::Vec3b>(row, col);
        color = bgr(mix({color[2], color[1], color[0]}, {0, 0, 0}, step < 1.0 ? 0.35 : 0.7));
      }
    }
  }
}

cv::Mat height_colors(const Samples& samples) {
  cv::Mat1b share(kSide, kSide);
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const double z = kTopShare * samples.height(row, col) / samples.top;
      share(row, col) = static_cast<uint8_t>(
          std::lround(255.0 * std::clamp(std::isfinite(z) ? z : 0.0, 0.0, 1.0)));
    }
  }
  cv::Mat colors;
  cv::applyColorMap(share, colors, cv::COLORMAP_TURBO);
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      cv::Vec3b& color = colors.at<cv::Vec3b>(row, col);
      const double sx = samples.slope_x(row, col), sy = samples.slope_y(row, col);
      if (!std::isfinite(samples.height(row, col))) {
        color = bgr(kNoDataColor);
      } else if (std::isfinite(sx) && std::isfinite(sy)) {
        // The light stands 45 degrees high in the top left corner.
        const double light = std::clamp(
            0.5 * (sx - sy + std::sqrt(2.0)) / std::sqrt(sx * sx + sy * sy + 1.0), 0.0, 1.0);
        for (int k = 0; k < 3; ++k) {
          color[k] = cv::saturate_cast<uint8_t>(color[k] * (0.35 + 0.9 * light));
        }
      }
    }
  }
  draw_contours(samples, &colors);
  return colors;
}

cv::Mat normal_colors(const Samples& samples) {
  cv::Mat colors(kSide, kSide, CV_8UC3);
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const double sx = samples.slope_x(row, col), sy = samples.slope_y(row, col);
      if (!std::isfinite(sx) || !std::isfinite(sy)) {
        colors.at<cv::Vec3b>(row, col) = bgr(kNoDataColor);
        continue;
      }
      const double length = std::sqrt(sx * sx + sy * sy + 1.0);
      const auto byte = [](double share) { return cv::saturate_cast<uint8_t>(255.0 * share); };
      colors.at<cv::Vec3b>(row, col) = {byte(1.0 / length), byte(0.5 - 0.5 * sy / length),
                                        byte(0.5 - 0.5 * sx / length)};
    }
  }
  return colors;
}

cv::Point pixel_of(const Eigen::Vector2d& crop) {
  return {static_cast<int>(std::lround(crop.x() * kScale)),
          static_cast<int>(std::lround(crop.y() * kScale))};
}

void draw_ring(const std::vector<Eigen::Vector2d>& ring, const Color& color, cv::Mat* panel) {
  std::vector<cv::Point> points;
  for (const Eigen::Vector2d& p : ring) points.push_back(pixel_of(p));
  if (points.size() < 2) return;
  cv::polylines(*panel, points, true, scalar(color), 1, cv::LINE_AA);
}

void draw_answer(const HouseAnswer& answer, cv::Mat* panel) {
  for (const CropRectangle& r : answer.rectangles) {
    draw_ring({{r.x0, r.y0}, {r.x1, r.y0}, {r.x1, r.y1}, {r.x0, r.y1}}, kOutlineColor, panel);
  }
  draw_ring(answer.polygon, kOutlineColor, panel);
  for (const auto& ring : answer.garages) draw_ring(ring, kGarageColor, panel);
  for (const Eigen::Vector2d& p : answer.dormers) {
    cv::circle(*panel, pixel_of(p), 5, scalar(kDormerColor), 1, cv::LINE_AA);
  }
  for (const Eigen::Vector2d& p : answer.chimneys) {
    cv::drawMarker(*panel, pixel_of(p), scalar(kChimneyColor), cv::MARKER_SQUARE, 8, 1,
                   cv::LINE_AA);
  }
}

void draw_inside(const HeightImage& image, const CropFrame& frame, cv::Mat* panel) {
  cv::Mat1b inside(kSide, kSide, static_cast<uint8_t>(0));
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      const Eigen::Vector2d p =
          frame.world_from_crop(crop_of_pixel(row, col)) - image.origin.head<2>();
      const long c = std::lround((p.x() - image.first_center.x()) / image.gsd);
      const long r = std::lround((image.first_center.y() - p.y()) / image.gsd);
      if (c < 0 || r < 0 || c >= image.cols || r >= image.rows) continue;
      inside(row, col) = image.inside[image.index(static_cast<int>(r), static_cast<int>(c))];
    }
  }
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(inside, contours, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
  cv::drawContours(*panel, contours, -1, scalar(kOutlineColor), 1);
}

void draw_crosses(cv::Mat* panel) {
  for (int y = kTickStep; y < kCropSize; y += kTickStep) {
    for (int x = kTickStep; x < kCropSize; x += kTickStep) {
      cv::drawMarker(*panel, {x * kScale, y * kScale}, scalar(kPaperColor), cv::MARKER_CROSS, 4, 1);
    }
  }
}

void place(const cv::Mat& panel, int left, cv::Mat* canvas) {
  const cv::Rect box(left, kTop, kSide, kSide);
  panel.copyTo((*canvas)(box));
  cv::rectangle(*canvas, cv::Rect(box.x - 1, box.y - 1, kSide + 2, kSide + 2), scalar(kInkColor),
                1);
  for (int t = 0; t <= kCropSize; t += kTickStep) {
    const int at = t * kScale;
    cv::line(*canvas, {left + at, kTop + kSide}, {left + at, kTop + kSide + 4}, scalar(kInkColor),
             1);
    cv::line(*canvas, {left - 5, kTop + at}, {left - 1, kTop + at}, scalar(kInkColor), 1);
    draw_text(*canvas, std::to_string(t), {left + at, kTop + kSide + 16}, 0.36, kInkColor,
              TextAnchor::kMiddle);
    draw_text(*canvas, std::to_string(t), {left - 7, kTop + at + 4}, 0.36, kInkColor,
              TextAnchor::kRight);
  }
}

}  // namespace

Grid grid_around(const CropFrame& frame, const Grid& raster) {
  Eigen::AlignedBox2d cells;  // rows and columns, to fractions
  for (const double x : {0.0, 1.0 * kCropSize}) {
    for (const double y : {0.0, 1.0 * kCropSize}) {
      cells.extend(raster.cell_of(frame.world_from_crop({x, y})));
    }
  }
  const auto cell = [](double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0, 1.0 * count));
  };
  const int top = cell(cells.min().x() - 1.0, raster.rows),
            bottom = cell(cells.max().x() + 3.0, raster.rows);
  const int left = cell(cells.min().y() - 1.0, raster.cols),
            right = cell(cells.max().y() + 3.0, raster.cols);
  Grid grid = raster;
  grid.north_west += Eigen::Vector2d(left * raster.gsd, -top * raster.gsd);
  grid.rows = std::max(0, bottom - top);
  grid.cols = std::max(0, right - left);
  return grid;
}

cv::Size annotation_panel_size() {
  return {2 * (kLeft + kSide) + kGap + 8, kTop + kSide + kBottom};
}

cv::Mat draw_annotation_panel(const AnnotationPanelInput& input) {
  const HouseAnswer& answer = *input.answer;
  const Samples samples = sample(input);
  cv::Mat heights = height_colors(samples), normals = normal_colors(samples);
  draw_crosses(&heights);
  draw_crosses(&normals);
  draw_answer(answer, &heights);
  if (input.image) {
    draw_inside(*input.image, answer.frame, &normals);
  } else {
    draw_answer(answer, &normals);
  }
  cv::Mat canvas(annotation_panel_size(), CV_8UC3, scalar(kPaperColor));
  place(heights, kLeft, &canvas);
  place(normals, 2 * kLeft + kSide + kGap, &canvas);
  draw_text(canvas, input.title, {kLeft, 14}, 0.45);
  draw_text(canvas,
            "crop pixel " + fixed(answer.frame.pixel, 3) + " m, cell " +
                fixed(input.dsm->grid.gsd, 2) + " m, red " + fixed(samples.top, 1) + " m",
            {kLeft, 30}, 0.4, kFaintInkColor);
  draw_scale_bar(canvas, {2 * kLeft + kSide + kGap, 26}, answer.frame.pixel / kScale, 120);
  return canvas;
}

double low_height(const HeightRaster& dsm, const CropFrame& frame) {
  std::vector<double> heights;
  for (int y = 0; y < kCropSize; ++y) {
    for (int x = 0; x < kCropSize; ++x) {
      const double z = height_at(dsm, frame.world_from_crop({x + 0.5, y + 0.5}));
      if (std::isfinite(z)) heights.push_back(z);
    }
  }
  if (heights.empty()) return 0.0;
  const auto low = heights.begin() + static_cast<long>(heights.size() / 5);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

}  // namespace gable
