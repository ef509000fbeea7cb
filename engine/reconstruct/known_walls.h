#pragma once

#include <gable/engine/io/building.h>
#include <gable/grammar/known_outline.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// The walls that a known outline gives a house: the outline with as few corners, filled as far
/// (outline_margins.h), as is nearest to the heights for its price. Empty where the house's own
/// rectangles are as near. outline: local frame of the image, which is the house's.
KnownOutline known_walls(const PlanPolygon& outline, const HeightImage& image,
                         const Building& house);

}  // namespace gable
