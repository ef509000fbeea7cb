#pragma once

#include <gable/engine/drawing/color.h>

namespace gable {

/// A sober colour for a shape, by its number from 0: neighbouring numbers are far apart in hue.
Color shape_color(int shape);

/// Elements that no shape holds.
inline constexpr Color kNoShapeColor{214, 215, 219};

/// The colour of a structural scale, from 1; grey for 0, fragments that no scale holds.
Color label_color(int label);

}  // namespace gable
