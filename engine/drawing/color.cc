#include <gable/engine/drawing/color.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gable {
namespace {

constexpr std::array<Color, 6> kHeightColors = {{{38, 46, 74},
                                                 {52, 88, 110},
                                                 {78, 128, 122},
                                                 {140, 166, 118},
                                                 {214, 200, 140},
                                                 {250, 243, 222}}};
constexpr Color kBelow{36, 84, 158};
constexpr Color kEqual{247, 247, 245};
constexpr Color kAbove{172, 38, 40};

}  // namespace

Color mix(const Color& a, const Color& b, double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  const auto channel = [t](uint8_t from, uint8_t to) {
    return static_cast<uint8_t>(std::lround(from + t * (to - from)));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

Color height_color(double share) {
  constexpr int kSteps = static_cast<int>(kHeightColors.size()) - 1;
  const double position = std::clamp(share, 0.0, 1.0) * kSteps;
  const int step = std::min(static_cast<int>(position), kSteps - 1);
  return mix(kHeightColors[step], kHeightColors[step + 1], position - step);
}

Color residual_color(double share) {
  return share < 0.0 ? mix(kEqual, kBelow, -share) : mix(kEqual, kAbove, share);
}

}  // namespace gable
