#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/grammar/known_outline.h>
#include <gable/residuals/height_image.h>

#include <limits>

namespace gable {

/// The walls that a known outline gives a house: the outline with as few corners, filled as far
/// (outline_margins.h), as is nearest to the heights for the triangles of its solids. Empty where
/// the house's own rectangles are as near for theirs. Walls without valid solids are left out, and
/// those that are farther from the heights on average than `farthest` (BuildingFit::charge, metres)
/// give way to those that are not. outline: local frame of the image, which is the house's.
KnownOutline known_walls(const PlanPolygon& outline, const HeightImage& image,
                         const Building& house,
                         double farthest = std::numeric_limits<double>::infinity());

}  // namespace gable
