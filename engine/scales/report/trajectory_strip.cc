#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/fixed.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <gable/engine/scales/report/trajectory_strip.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

namespace gable {
namespace {

constexpr int kLeft = 74, kRight = 26, kTop = 46, kCurveHeight = 150, kGap = 10;
constexpr int kStripHeight = 34, kFoot = 50;
constexpr int kBadge = 10;               ///< radius of a mark's number, pixels
constexpr int kTickDistance = 40;        ///< pixels
constexpr double kSmallestShare = 1e-6;  ///< of the largest weight, that the curve goes down to
constexpr double kText = 0.4;
constexpr Color kGridColor{226, 228, 232};

struct Decades {
  int low = 0, high = 0;
  bool empty() const { return low >= high; }
};

Decades decades_of(const std::vector<Merge>& merges) {
  double least = INFINITY, most = 0.0;
  for (const Merge& merge : merges) most = std::max(most, merge.weight);
  for (const Merge& merge : merges) {
    if (merge.weight >= kSmallestShare * most && merge.weight > 0.0) {
      least = std::min(least, merge.weight);
    }
  }
  if (!(most > 0.0)) return {};
  const int low = static_cast<int>(std::floor(std::log10(least)));
  return {low, std::max(low + 1, static_cast<int>(std::ceil(std::log10(most))))};
}

void draw_curve(cv::Mat& canvas, const cv::Rect& area, const Trajectory& trajectory,
                const ShapeNumberAxis& axis) {
  const Decades decades = decades_of(trajectory.merges);
  if (decades.empty()) return;
  const auto row = [&](double weight) {
    const double share = (std::log10(std::max(weight, 1e-300)) - decades.low) /
                         static_cast<double>(decades.high - decades.low);
    return area.y + (1.0 - std::clamp(share, 0.0, 1.0)) * area.height;
  };
  for (int d = decades.low; d <= decades.high; ++d) {
    const int y = static_cast<int>(std::lround(row(std::pow(10.0, d))));
    cv::line(canvas, {area.x, y}, {area.x + area.width, y}, scalar(kGridColor));
    draw_text(canvas, fixed(std::pow(10.0, d), std::max(0, -d)) + " m", {area.x - 8, y + 4}, kText,
              kFaintInkColor, TextAnchor::kRight);
  }
  constexpr int kSubpixels = 4;  // bits
  std::vector<cv::Point> line;
  for (size_t i = 0; i < trajectory.merges.size(); ++i) {
    const double x = area.x + axis.position(static_cast<int>(i) + 1);
    const double y = row(trajectory.merges[i].weight);
    line.emplace_back(static_cast<int>(std::lround(x * (1 << kSubpixels))),
                      static_cast<int>(std::lround(y * (1 << kSubpixels))));
  }
  cv::polylines(canvas, line, false, scalar(kInkColor), 1, cv::LINE_AA, kSubpixels);
}

/// Numbers of shapes below the strip, where there is room.
void draw_ticks(cv::Mat& canvas, const cv::Rect& strip, const Trajectory& trajectory,
                const ShapeNumberAxis& axis) {
  const int bottom = strip.y + strip.height;
  const int last = trajectory.num_shapes(trajectory.num_configurations() - 1);
  const auto draw = [&](int number) {
    const double middle =
        (axis.position_of_number(number) + axis.position_of_number(number - 1)) / 2;
    const int x = strip.x + static_cast<int>(std::lround(middle));
    cv::line(canvas, {x, bottom}, {x, bottom + 4}, scalar(kFaintInkColor));
    draw_text(canvas, std::to_string(number), {x, bottom + 18}, kText, kFaintInkColor,
              TextAnchor::kMiddle);
    return x;
  };
  int free_from = draw(trajectory.num_first) + kTickDistance;
  for (int power = 1000000000; power >= 1; power /= 10) {
    for (const int factor : {5, 2, 1}) {
      if (power > trajectory.num_first / factor) continue;
      const int number = factor * power;
      const int x = strip.x + static_cast<int>(axis.position_of_number(number));
      if (number >= trajectory.num_first || number < last || x < free_from) continue;
      free_from = draw(number) + kTickDistance;
    }
  }
  draw_text(canvas, "number of shapes", {strip.x + strip.width / 2, bottom + 40}, kText,
            kFaintInkColor, TextAnchor::kMiddle);
}

}  // namespace

ShapeNumberAxis::ShapeNumberAxis(const Trajectory& trajectory, int width)
    : num_first_(std::max(trajectory.num_first, 1)),
      num_last_(num_first_ - static_cast<int>(trajectory.merges.size())),
      width_(width) {
  CHECK_GE(num_last_, 1);
}

double ShapeNumberAxis::position_of_number(double num_shapes) const {
  const double left = std::log(num_first_ + 0.5), right = std::log(num_last_ - 0.5);
  return width_ * (left - std::log(num_shapes + 0.5)) / (left - right);
}

double ShapeNumberAxis::position(int configuration) const {
  return position_of_number(num_first_ - configuration);
}

int ShapeNumberAxis::configuration(int column) const {
  const double left = std::log(num_first_ + 0.5), right = std::log(num_last_ - 0.5);
  const double number = std::exp(left + (right - left) * (column + 0.5) / width_);
  return num_first_ - std::clamp(static_cast<int>(std::lround(number)), num_last_, num_first_);
}

TrajectoryStrip draw_trajectory_strip(const Trajectory& trajectory, const ScaleLabels& labels,
                                      int width) {
  CHECK_GE(width, 320);
  CHECK_EQ(labels.num_configurations, trajectory.num_configurations());
  TrajectoryStrip out;
  const cv::Rect curve(kLeft, kTop, width - kLeft - kRight, kCurveHeight);
  out.strip = {kLeft, kTop + kCurveHeight + kGap, curve.width, kStripHeight};
  out.image = cv::Mat(out.strip.y + kStripHeight + kFoot, width, CV_8UC3, scalar(kPaperColor));
  const ShapeNumberAxis axis(trajectory, curve.width);
  draw_curve(out.image, curve, trajectory, axis);
  draw_text(out.image, "RMS distance of the merge", {4, 16}, kText, kFaintInkColor);

  const std::vector<int> label = labels.labels();
  for (int column = 0; column < out.strip.width; ++column) {
    const Color color = label_color(label[axis.configuration(column)]);
    out.image(cv::Rect(out.strip.x + column, out.strip.y, 1, out.strip.height))
        .setTo(scalar(color));
  }
  draw_ticks(out.image, out.strip, trajectory, axis);

  int previous = -1000;
  int raised = 0;
  for (int scale = 1; scale <= labels.num_scales(); ++scale) {
    const int x =
        out.strip.x + static_cast<int>(std::lround(axis.position(labels.first[scale - 1])));
    out.marks.push_back(x);
    raised = x - previous < 2 * kBadge + 2 ? std::min(raised + 1, 2) : 0;
    previous = x;
    const int y = kTop - kBadge - 4 + raised * (2 * kBadge + 2);
    cv::line(out.image, {x, y}, {x, out.strip.y + kStripHeight}, scalar(kInkColor));
    cv::circle(out.image, {x, y}, kBadge, scalar(label_color(scale)), cv::FILLED, cv::LINE_AA);
    draw_text(out.image, std::to_string(scale), {x, y + 5}, 0.45, kPaperColor, TextAnchor::kMiddle);
  }
  return out;
}

}  // namespace gable
