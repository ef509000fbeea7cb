#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// Smallest height in the square of (2 radius + 1)^2 cells around each cell. Cells without a height
/// and cells outside the raster are left out; NaN where nothing is left. Time does not depend on
/// the radius (van Herk 1992, Gil and Werman 1993).
HeightRaster erode(const HeightRaster& heights, int radius);

/// Largest height in the same square.
HeightRaster dilate(const HeightRaster& heights, int radius);

/// Erosion, then dilation: removes whatever rises above its surroundings and is narrower than the
/// square. Never above `heights` where that has a height.
HeightRaster open(const HeightRaster& heights, int radius);

}  // namespace gable
