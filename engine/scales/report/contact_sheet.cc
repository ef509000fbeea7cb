#include <gable/engine/drawing/canvas.h>
#include <gable/engine/scales/report/configuration_picture.h>
#include <gable/engine/scales/report/contact_sheet.h>
#include <gable/engine/scales/report/lasting_numbers.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

namespace gable {
namespace {

constexpr int kHead = 34, kPad = 10, kCaption = 24, kUnderline = 6;
/// Above 1: steps get smaller towards the coarse end.
constexpr double kCoarseBias = 1.25;

int last_of(const Trajectory& trajectory, const ContactSheetOptions& options) {
  const int last = trajectory.num_configurations() - 1;
  return options.last_configuration < 0 ? last : std::min(options.last_configuration, last);
}

/// "begins 1, 2": the scales of which a configuration is the first; empty if of none.
std::string beginnings(const ScaleLabels& labels, int configuration) {
  std::string text;
  for (int scale = 1; scale <= labels.num_scales(); ++scale) {
    if (labels.first[scale - 1] != configuration) continue;
    text += (text.empty() ? "begins " : ", ") + std::to_string(scale);
  }
  return text;
}

/// Configurations from `first` to `last` in `count` steps of the logarithm of their shapes.
std::set<int> spread(const Trajectory& trajectory, int first, int last, int count) {
  std::set<int> out;
  const double many = std::log(std::max(trajectory.num_shapes(first), 1));
  const double few = std::log(std::max(trajectory.num_shapes(last), 1));
  for (int i = 0; i < count; ++i) {
    const double t = count > 1 ? static_cast<double>(i) / (count - 1) : 1.0;
    const double number = std::exp(few + std::pow(1.0 - t, kCoarseBias) * (many - few));
    out.insert(
        std::clamp(trajectory.num_first - static_cast<int>(std::lround(number)), first, last));
  }
  return out;
}

}  // namespace

std::string check(const ContactSheetOptions& options) {
  if (options.columns < 1 || options.columns > 64) return "columns must be in [1, 64]";
  if (options.rows < 1 || options.rows > 64) return "rows must be in [1, 64]";
  if (options.thumbnail_width < 64 || options.thumbnail_width > 2048) {
    return "thumbnail_width must be in [64, 2048]";
  }
  if (options.thumbnail_height < 64 || options.thumbnail_height > 2048) {
    return "thumbnail_height must be in [64, 2048]";
  }
  if (options.first_configuration < 0) return "first_configuration must be >= 0";
  if (options.last_configuration >= 0 && options.last_configuration < options.first_configuration) {
    return "last_configuration must be -1 or >= first_configuration";
  }
  return "";
}

std::vector<int> sheet_configurations(const Trajectory& trajectory, const ScaleLabels& labels,
                                      const ContactSheetOptions& options) {
  CHECK(check(options).empty()) << check(options);
  const int last = last_of(trajectory, options);
  const int first = std::min(options.first_configuration, last);
  const size_t room = static_cast<size_t>(options.columns) * options.rows;
  std::set<int> begun;
  for (const int f : labels.first) {
    if (f >= first && f <= last && begun.size() < room) begun.insert(f);
  }
  // The more steps, the more configurations, until the sheet is full or shows all there are.
  std::set<int> best = begun;
  const size_t all = last - first + 1;
  for (int steps = 1; best.size() < std::min(room, all) && steps <= 64 * 64 * 4; ++steps) {
    std::set<int> chosen = spread(trajectory, first, last, steps);
    chosen.insert(begun.begin(), begun.end());
    if (chosen.size() > room) break;
    if (chosen.size() > best.size()) best = std::move(chosen);
  }
  return {best.begin(), best.end()};
}

cv::Mat draw_contact_sheet(const Scan& scan, const FirstShapes& first_shapes,
                           const Trajectory& trajectory, const ScaleLabels& labels,
                           const std::string& title, const ContactSheetOptions& options) {
  const std::vector<int> shown = sheet_configurations(trajectory, labels, options);
  CHECK_EQ(first_shapes.shape_of.size(), scan.num_elements());
  const std::vector<int> label = labels.num_scales() > 0
                                     ? labels.labels()
                                     : std::vector<int>(trajectory.num_configurations(), 0);
  CHECK_EQ(static_cast<int>(label.size()), trajectory.num_configurations());
  const int width = options.thumbnail_width, height = options.thumbnail_height;
  const int cell_width = width + kPad, cell_height = height + kCaption + kUnderline + kPad;
  const int rows = (static_cast<int>(shown.size()) + options.columns - 1) / options.columns;
  cv::Mat sheet(kHead + rows * cell_height, options.columns * cell_width + kPad, CV_8UC3,
                scalar(kPaperColor));
  draw_text(sheet, title, {kPad, 23}, 0.6);
  const AxonometricView view = view_of(scan.points, width, height);
  const LastingNumbers numbers(trajectory, first_shapes);
  std::vector<int> shape_of(scan.num_elements());
  for (size_t i = 0; i < shown.size(); ++i) {
    const int configuration = shown[i];
    const std::vector<int> shapes = numbers.at(configuration);
    for (size_t e = 0; e < shape_of.size(); ++e) {
      const int first = first_shapes.shape_of[e];
      shape_of[e] = first < 0 ? -1 : shapes[first];
    }
    const int x = kPad + static_cast<int>(i) % options.columns * cell_width;
    const int y = kHead + static_cast<int>(i) / options.columns * cell_height;
    draw_elements(scan, shape_of, view).copyTo(sheet(cv::Rect(x, y, width, height)));
    const int baseline = y + height + 16;
    draw_text(sheet, "#" + std::to_string(configuration), {x + 2, baseline}, 0.5);
    draw_text(sheet, std::to_string(trajectory.num_shapes(configuration)) + " shapes",
              {x + width - 2, baseline}, 0.45, kFaintInkColor, TextAnchor::kRight);
    const cv::Rect underline(x, y + height + kCaption, width, kUnderline);
    const Color color = label_color(label[configuration]);
    sheet(underline).setTo(scalar(color));
    const std::string begins = beginnings(labels, configuration);
    if (begins.empty()) continue;
    draw_text(sheet, begins, {x + width * 45 / 100, baseline}, 0.5, kInkColor, TextAnchor::kMiddle);
    cv::rectangle(sheet, cv::Rect(x, y, width, height + kCaption + kUnderline), scalar(color), 3);
  }
  return sheet;
}

}  // namespace gable
