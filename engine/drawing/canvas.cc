#include <gable/engine/drawing/canvas.h>
#include <gable/engine/drawing/fixed.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;

}  // namespace

double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= length) return factor * power;
  }
  return power;
}

void draw_text(cv::Mat& canvas, const std::string& text, cv::Point baseline, double size,
               const Color& color, TextAnchor anchor) {
  std::string ascii = text;
  for (char& c : ascii) {
    if (c < ' ' || c > '~') c = '?';
  }
  int below = 0;
  const int width = cv::getTextSize(ascii, kFont, size, 1, &below).width;
  if (anchor == TextAnchor::kMiddle) baseline.x -= width / 2;
  if (anchor == TextAnchor::kRight) baseline.x -= width;
  cv::putText(canvas, ascii, baseline, kFont, size, scalar(color), 1, cv::LINE_AA);
}

void draw_color_bar(cv::Mat& canvas, const cv::Rect& bar, Color (*color_of)(double), double low,
                    double high) {
  for (int x = 0; x < bar.width; ++x) {
    const Color color = color_of(low + (high - low) * (x + 0.5) / bar.width);
    canvas(cv::Rect(bar.x + x, bar.y, 1, bar.height)).setTo(scalar(color));
  }
  cv::rectangle(canvas, bar, scalar(kFaintInkColor), 1);
}

void draw_scale_bar(cv::Mat& canvas, cv::Point left, double meters_per_pixel, int max_pixels) {
  const double length = round_length(max_pixels * meters_per_pixel);
  const int pixels = static_cast<int>(std::lround(length / meters_per_pixel));
  const cv::Point right = left + cv::Point(pixels, 0);
  const cv::Scalar ink = scalar(kInkColor);
  cv::line(canvas, left, right, ink, 2);
  for (const cv::Point& end : {left, right}) {
    cv::line(canvas, end - cv::Point(0, 4), end + cv::Point(0, 4), ink, 1);
  }
  draw_text(canvas, fixed(length, length < 1.0 ? 1 : 0) + " m", right + cv::Point(8, 4), 0.4);
}

}  // namespace gable
