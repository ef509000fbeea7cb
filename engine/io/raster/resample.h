#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// Heights of `source` at the cell centres of `target`: bilinear between the four nearest centres,
/// of which those without a height are left out. NaN where those left carry less than a quarter of
/// the weight, so values reach half a cell beyond the outermost centres and no further.
HeightRaster resample_bilinear(const HeightRaster& source, const Grid& target);

/// Whether the extents of two grids share an area.
bool overlap(const Grid& a, const Grid& b);

}  // namespace gable
