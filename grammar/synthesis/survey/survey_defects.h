#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>

namespace gable {

/// Blends every cell with its neighbours: `share` of it is the mean weighted 1 2 1 both ways,
/// [0, 1]. Missing cells stay missing and count for nothing.
void blend_cells(double share, HeightRaster* surface);

/// Takes cells away (NaN): single cells anywhere, blobs on and around the building, and what lies
/// in the shadow of walls seen from one side; each kind in some surveys.
void random_holes(Random* random, HeightRaster* surface);

}  // namespace gable
