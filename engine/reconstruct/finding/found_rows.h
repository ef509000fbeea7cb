#pragma once

#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/finding/row_cuts.h>
#include <gable/grammar/raster.h>

#include <cstddef>
#include <vector>

namespace gable {

/// Cuts house `index` of those found on the grid of the two rasters into pieces (`cut_rows`). The
/// first keeps its place, the others are appended. Returns the places of all, in the order of
/// their first cells.
std::vector<size_t> cut_found_row(const HeightRaster& dsm, const HeightRaster& dtm, size_t index,
                                  const RowCutOptions& options, FoundHouses* found);

}  // namespace gable
