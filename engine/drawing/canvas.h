#pragma once

#include <gable/engine/drawing/color.h>

#include <opencv2/core.hpp>
#include <string>

namespace gable {

/// OpenCV's order of channels.
inline cv::Vec3b bgr(const Color& color) { return {color.blue, color.green, color.red}; }
inline cv::Scalar scalar(const Color& color) {
  return {static_cast<double>(color.blue), static_cast<double>(color.green),
          static_cast<double>(color.red)};
}

inline constexpr Color kPaperColor{255, 255, 255};
inline constexpr Color kInkColor{44, 46, 52};
inline constexpr Color kFaintInkColor{110, 114, 122};

/// How a text is set against the point it is given.
enum class TextAnchor { kLeft, kMiddle, kRight };

/// Writes ASCII text on its baseline; other characters become '?'. `size` 1 is about 22 pixels
/// high.
void draw_text(cv::Mat& canvas, const std::string& text, cv::Point baseline, double size,
               const Color& color = kInkColor, TextAnchor anchor = TextAnchor::kLeft);

/// A horizontal bar of colours from share `low` to `high` of `color_of`, framed.
void draw_color_bar(cv::Mat& canvas, const cv::Rect& bar, Color (*color_of)(double), double low,
                    double high);

/// A length of the plan, drawn as a bar of `meters_per_pixel` with its length above it; the length
/// is 1, 2 or 5 times a power of ten and at most `max_pixels` wide.
void draw_scale_bar(cv::Mat& canvas, cv::Point left, double meters_per_pixel, int max_pixels);

/// The largest of 1, 2 and 5 times a power of ten that is no larger than `length` (> 0).
double round_length(double length);

}  // namespace gable
