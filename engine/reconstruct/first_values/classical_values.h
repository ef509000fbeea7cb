#pragma once

#include <gable/engine/reconstruct/first_values/first_values.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// First values without learning: for every direction of the building's walls, sets of rectangles
/// between edge lines with the roofs that fit their cells best (azimuth.h, block_search.h), at most
/// `per_foundation` of each foundation type and direction. Houses have the image's origin.
std::vector<FirstValue> classical_values(const HeightImage& image, int per_foundation);

}  // namespace gable
