#include "comparison_picture.h"

#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/fixed.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/report/height_panels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gable {
namespace {

constexpr int kPanels = 5;
constexpr int kMargin = 12;
constexpr int kTitle = 30;
constexpr int kNames = 42;   // two lines above the panels
constexpr int kLegend = 40;  // below them
constexpr double kSmall = 0.4;
constexpr double kShownAround = 2.0;    // metres
constexpr int kLevels = 20;             // a colour channel
constexpr double kResidualRange = 1.0;  // metres

HeightImage cut_to_building(const HeightImage& image) {
  int row0 = image.rows, row1 = 0, col0 = image.cols, col1 = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      if (!image.inside[image.index(row, col)]) continue;
      row0 = std::min(row0, row), row1 = std::max(row1, row + 1);
      col0 = std::min(col0, col), col1 = std::max(col1, col + 1);
    }
  }
  const int around = static_cast<int>(kShownAround / image.gsd);
  row0 = std::max(row0 - around, 0), row1 = std::min(row1 + around, image.rows);
  col0 = std::max(col0 - around, 0), col1 = std::min(col1 + around, image.cols);
  HeightImage cut;
  cut.origin = image.origin;
  cut.first_center = image.center_of(row0, col0);
  cut.gsd = image.gsd;
  cut.rows = row1 - row0, cut.cols = col1 - col0;
  for (int row = row0; row < row1; ++row) {
    for (int col = col0; col < col1; ++col) {
      const size_t i = image.index(row, col);
      cut.height.push_back(image.height[i]);
      cut.ground.push_back(image.ground[i]);
      cut.weight.push_back(image.weight[i]);
      cut.inside.push_back(image.inside[i]);
    }
  }
  return cut;
}

std::string figures(const HeightImage& image, const Building& building) {
  const BuildingFit fit = fit_of_building(image, building);
  return "MAD " + fixed(fit.mad, 2) + " m, charge " + fixed(fit.charge, 2) + " m";
}

void draw_legends(cv::Mat& canvas, const std::array<int, kPanels>& lefts, int top, int width,
                  const HeightRange& range, double metres_per_pixel) {
  draw_color_bar(canvas, {lefts[0], top, width, 8}, height_color, 0.0, 1.0);
  draw_text(canvas, fixed(range.low, 1), {lefts[0], top + 22}, kSmall);
  draw_text(canvas, fixed(range.high, 1) + " m", {lefts[0] + width, top + 22}, kSmall, kInkColor,
            TextAnchor::kRight);
  draw_scale_bar(canvas, {lefts[1], top + 7}, metres_per_pixel, width / 2);
  draw_color_bar(canvas, {lefts[2], top, width, 8}, residual_color, -1.0, 1.0);
  draw_text(canvas, "-" + fixed(kResidualRange, 1), {lefts[2], top + 22}, kSmall);
  draw_text(canvas, "+" + fixed(kResidualRange, 1) + " m", {lefts[2] + width, top + 22}, kSmall,
            kInkColor, TextAnchor::kRight);
}

void draw_pair(const ComparedPair& pair, int panel_size, int top, cv::Mat& canvas) {
  const HeightImage image = cut_to_building(pair.image);
  const std::vector<float> without =
      model_heights(BuildingSurface(pair.without.building, image.origin), image);
  const std::vector<float> with =
      model_heights(BuildingSurface(pair.with.building, image.origin), image);
  const HeightRange a = shown_range(image, without), b = shown_range(image, with);
  const HeightRange range{std::min(a.low, b.low), std::max(a.high, b.high)};
  const PanelScale scale(image, panel_size);
  const cv::Mat panels[kPanels] = {height_panel(image, image.height, range, true, scale),
                                   height_panel(image, without, range, false, scale),
                                   residual_panel(image, without, kResidualRange, scale),
                                   height_panel(image, with, range, false, scale),
                                   residual_panel(image, with, kResidualRange, scale)};
  const std::string names[kPanels][2] = {
      {pair.id, "measured height"},
      {pair.without.name, figures(pair.image, pair.without.building)},
      {"", "measured - model"},
      {pair.with.name, figures(pair.image, pair.with.building)},
      {"", "measured - model"}};
  std::array<int, kPanels> lefts{};
  for (int i = 0; i < kPanels; ++i) {
    lefts[i] = kMargin + i * (panel_size + kMargin);
    draw_text(canvas, names[i][0], {lefts[i], top + 14}, kSmall);
    draw_text(canvas, names[i][1], {lefts[i], top + 32}, kSmall, kFaintInkColor);
    panels[i].copyTo(canvas({lefts[i], top + kNames, scale.width, scale.height}));
  }
  draw_legends(canvas, lefts, top + kNames + scale.height + 10, scale.width, range,
               image.gsd / scale.pixels_per_cell);
}

int height_of(const ComparedPair& pair, int panel_size) {
  return kNames + PanelScale(cut_to_building(pair.image), panel_size).height + kLegend;
}

// Noise in all colours makes large files.
void round_colors(cv::Mat& canvas) {
  cv::Mat levels(1, 256, CV_8U);
  for (int i = 0; i < 256; ++i) {
    const double level = std::round(i * (kLevels - 1) / 255.0);
    levels.at<uint8_t>(i) = static_cast<uint8_t>(std::round(level * 255.0 / (kLevels - 1)));
  }
  cv::LUT(canvas, levels, canvas);
}

}  // namespace

cv::Mat draw_comparison(const std::string& title, const std::vector<ComparedPair>& pairs,
                        int panel_size) {
  int rows = kTitle;
  for (const ComparedPair& pair : pairs) rows += height_of(pair, panel_size);
  cv::Mat canvas(rows, kPanels * panel_size + (kPanels + 1) * kMargin, CV_8UC3,
                 scalar(kPaperColor));
  draw_text(canvas, title, {kMargin, 22}, 0.5);
  int top = kTitle;
  for (const ComparedPair& pair : pairs) {
    draw_pair(pair, panel_size, top, canvas);
    top += height_of(pair, panel_size);
  }
  round_colors(canvas);
  return canvas;
}

}  // namespace gable
