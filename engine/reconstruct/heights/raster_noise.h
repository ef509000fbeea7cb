#pragma once

#include <gable/residuals/height_image.h>

namespace gable {

/// Standard deviation of a building's heights about planes through 3 x 3 pixels, metres: from the
/// median over all neighbourhoods that lie inside and are evidence, since most of a roof is a plane
/// over three cells. 0 where there is no such neighbourhood.
double raster_noise(const HeightImage& image);

}  // namespace gable
