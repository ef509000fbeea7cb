#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/color.h>
#include <gable/engine/drawing/fixed.h>
#include <gable/engine/reconstruct/report/building_surface.h>
#include <gable/engine/reconstruct/report/height_panels.h>
#include <gable/engine/reconstruct/report/house_picture.h>
#include <gable/engine/reconstruct/report/parts_panel.h>

#include <iterator>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace gable {
namespace {

constexpr int kMargin = 16;
constexpr int kHeader = 58;  // the title, and the panels' names on the panels' upper edge
constexpr int kLegend = 48;  // below the panels
constexpr double kSmall = 0.4;
constexpr size_t kMaxTitle = 80;

std::string title(const Building& building) {
  std::string id = building.id.substr(0, kMaxTitle);
  if (!building.house) return id + "   " + building_status_name(building.status);
  return id + "   foundation " + std::string(foundation_name(building.house->foundation)) +
         "   roofs " + roof_list(*building.house);
}

std::string figures(const FitQuality& quality) {
  return "MAD " + fixed(quality.mad, 2) + " m   RMSE " + fixed(quality.rmse, 2) + " m";
}

void draw_height_legend(cv::Mat& canvas, const cv::Rect& area, const HeightRange& range) {
  draw_color_bar(canvas, {area.x, area.y, area.width, 10}, height_color, 0.0, 1.0);
  const int below = area.y + 25;
  draw_text(canvas, fixed(range.low, 1), {area.x, below}, kSmall);
  draw_text(canvas, fixed(0.5 * (range.low + range.high), 1), {area.x + area.width / 2, below},
            kSmall, kInkColor, TextAnchor::kMiddle);
  draw_text(canvas, fixed(range.high, 1) + " m", {area.x + area.width, below}, kSmall, kInkColor,
            TextAnchor::kRight);
}

void draw_residual_legend(cv::Mat& canvas, const cv::Rect& area, double range) {
  draw_color_bar(canvas, {area.x, area.y, area.width, 10}, residual_color, -1.0, 1.0);
  for (const int quarter : {-2, -1, 0, 1, 2}) {
    const int x = area.x + area.width * (quarter + 2) / 4;
    const TextAnchor anchor = quarter == -2  ? TextAnchor::kLeft
                              : quarter == 2 ? TextAnchor::kRight
                                             : TextAnchor::kMiddle;
    const double value = 0.5 * quarter * range;
    draw_text(
        canvas,
        (quarter > 0 ? "+" : "") + fixed(value, range < 1.0 ? 2 : 1) + (quarter == 2 ? " m" : ""),
        {x, area.y + 25}, kSmall, kInkColor, anchor);
  }
}

// Two rows of swatches with the number of parts of each kind.
void draw_parts_legend(cv::Mat& canvas, const cv::Rect& area, const Building& building) {
  struct Entry {
    std::string name;
    Color color;
  };
  std::vector<Entry> entries;
  const auto add = [&entries](const char* name, size_t count, const Color& color) {
    entries.push_back({std::string(name) + " " + std::to_string(count), color});
  };
  if (building.house) {
    add("components", building.house->roofs.size(), kComponentColors[0]);
    add("garages", building.house->garages.size(), kGarageColor);
    add("dormers", building.house->dormers.size(), kDormerColor);
    add("chimneys", building.house->chimneys.size(), kChimneyColor);
  } else if (building.roof) {
    add("planes", building.roof->planes.size(), kComponentColors[0]);
  } else {
    entries.push_back({"outline at one height", kComponentColors[0]});
  }
  for (size_t i = 0; i < entries.size(); ++i) {
    const int x = area.x + static_cast<int>(i % 2) * area.width / 2;
    const int y = area.y + static_cast<int>(i / 2) * 20;
    const cv::Rect swatch(x, y, 14, 12);
    cv::rectangle(canvas, swatch, scalar(entries[i].color), cv::FILLED);
    cv::rectangle(canvas, swatch, scalar(kFaintInkColor), 1);
    draw_text(canvas, entries[i].name, {x + 22, y + 11}, kSmall);
  }
}

}  // namespace

std::string check(const HousePictureOptions& options) {
  if (options.panel_size < 64 || options.panel_size > 2048) {
    return "panel_size must be in [64, 2048]";
  }
  if (!(options.residual_range > 0.0 && options.residual_range <= 100.0)) {
    return "residual_range must be in (0, 100] metres";
  }
  return "";
}

std::string roof_list(const House& house) {
  std::string list;
  for (const Rule& roof : house.roofs) {
    if (!list.empty()) list += ", ";
    list += roof_name(roof.kind);
  }
  return list;
}

HousePicture draw_house_picture(const Building& building, const HeightImage& image,
                                const HousePictureOptions& options) {
  const int panel = options.panel_size;
  HousePicture picture;
  picture.image.create(kHeader + panel + kLegend, 5 * kMargin + 4 * panel, CV_8UC3);
  picture.image.setTo(scalar(kPaperColor));
  cv::Mat& canvas = picture.image;

  draw_text(canvas, title(building), {kMargin, 24}, 0.5);
  draw_text(canvas, figures(building.quality), {canvas.cols - kMargin, 24}, 0.5, kInkColor,
            TextAnchor::kRight);

  const BuildingSurface surface(building, image.origin);
  const std::vector<float> model = model_heights(surface, image);
  const HeightRange range = shown_range(image, model);
  const PanelScale scale(image, panel);
  const cv::Mat views[4] = {height_panel(image, image.height, range, true, scale),
                            height_panel(image, model, range, false, scale),
                            residual_panel(image, model, options.residual_range, scale),
                            parts_panel(surface, image, scale)};
  const char* names[4] = {"measured height", "model height", "measured - model",
                          "parts and ridges"};
  for (int i = 0; i < 4; ++i) {
    const cv::Point corner(kMargin + i * (panel + kMargin), kHeader);
    picture.panels[i] = {corner.x, corner.y, scale.width, scale.height};
    views[i].copyTo(canvas(picture.panels[i]));
    draw_text(canvas, names[i], corner - cv::Point(0, 8), kSmall, kFaintInkColor);
  }

  const auto legend = [&](int i) {
    return cv::Rect(kMargin + i * (panel + kMargin), kHeader + panel + 10, panel, kLegend - 10);
  };
  draw_height_legend(canvas, legend(0), range);
  draw_scale_bar(canvas, legend(1).tl() + cv::Point(0, 7), image.gsd / scale.pixels_per_cell,
                 panel / 3);
  draw_residual_legend(canvas, legend(2), options.residual_range);
  draw_parts_legend(canvas, legend(3), building);
  return picture;
}

}  // namespace gable
