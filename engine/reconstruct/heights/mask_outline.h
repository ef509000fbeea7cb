#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// The outline of the largest connected piece of the inside pixels, along pixel edges, simplified
/// by Douglas and Peucker's algorithm so that no vertex moves by more than `tolerance` metres;
/// local frame of the image. Holes under four square metres are closed. Empty where no pixel is
/// inside.
PlanPolygon outline_of_mask(const HeightImage& image, double tolerance);

}  // namespace gable
