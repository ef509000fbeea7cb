#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// Fills the cells without a height by a smooth surface through the others: an approximate solution
/// of Laplace's equation, solved coarse to fine (cascadic multigrid) with mirrored borders. Cells
/// with a height keep it. All NaN stays all NaN.
HeightRaster fill_smoothly(const HeightRaster& heights);

}  // namespace gable
