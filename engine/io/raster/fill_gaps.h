#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// Fills narrow gaps: a cell without a height that has cells with one on two opposite sides (along
/// a row, a column or a diagonal), each at most `reach` cells away, reach >= 1. Of these pairs the
/// closest counts. The height is linear between the two or, where they are `step` metres and more
/// apart, that of the nearer one, of two equally near ones the higher: a wall is not smeared. Cells
/// of the raster alone are looked at, as they are before any is filled.
HeightRaster fill_narrow_gaps(const HeightRaster& heights, int reach, float step = 1.0f);

}  // namespace gable
