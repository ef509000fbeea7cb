#pragma once

#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// Heights of the inside pixels that count, metres, row by row.
std::vector<float> measured_heights(const HeightImage& image);

}  // namespace gable
