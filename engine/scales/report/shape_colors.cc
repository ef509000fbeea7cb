#include <gable/engine/scales/report/shape_colors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gable {
namespace {

/// sRGB of the OKLCh colour space (B. Ottosson 2020), whose lightness and hue are perceived as
/// even. `hue` in turns.
Color from_oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(2.0 * std::numbers::pi * hue);
  const double b = chroma * std::sin(2.0 * std::numbers::pi * hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
  const auto channel = [](double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<uint8_t>(std::lround(255.0 * encoded));
  };
  return {channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

constexpr double kGoldenTurn = 0.38196601125010515;
constexpr std::array<double, 3> kLightness = {0.84, 0.76, 0.80};
constexpr std::array<double, 3> kChroma = {0.085, 0.095, 0.075};

}  // namespace

Color shape_color(int shape) {
  const double hue = std::fmod(0.68 + kGoldenTurn * shape, 1.0);
  return from_oklch(kLightness[shape % 3], kChroma[shape / 3 % 3], hue);
}

Color label_color(int label) {
  if (label <= 0) return {186, 188, 192};
  return from_oklch(0.62, 0.105, std::fmod(0.67 + kGoldenTurn * (label - 1), 1.0));
}

}  // namespace gable
