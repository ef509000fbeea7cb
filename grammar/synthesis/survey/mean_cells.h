#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// How a raster's cells come from finer heights.
enum class CellMeans {
  kOver,       ///< each is the mean over it
  kResampled,  ///< the same, resampled once: weights fall linearly to 0 over a cell beyond its
               ///< middle
};

/// A raster of cells `factor` times as wide, even, from the same north-western corner; what
/// no whole cell covers is left out. `fine` must have heights everywhere.
HeightRaster mean_cells(const HeightRaster& fine, int factor, CellMeans means);

}  // namespace gable
