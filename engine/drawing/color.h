#pragma once

#include <cstdint>

namespace gable {

/// An sRGB colour.
struct Color {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
  bool operator==(const Color&) const = default;
};

/// The straight line between two colours: a at 0, b at 1; `share` is clamped to [0, 1].
Color mix(const Color& a, const Color& b, double share);

/// Colour of a height: `share` 0 is the lowest (dark slate), 1 the highest (light sand), with a
/// lightness that only grows.
Color height_color(double share);

/// Colour of a residual as a share of the range shown: -1 blue, 0 near white, 1 red; clamped.
Color residual_color(double share);

/// Pixels that nothing is known about.
inline constexpr Color kNoDataColor{206, 206, 210};

}  // namespace gable
