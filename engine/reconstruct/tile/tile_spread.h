#pragma once

#include <gable/engine/io/raster/height_source.h>

namespace gable {

/// The spread of a raster of any size (`raster_spread`), told by parts of it that lie scattered
/// over it: as many as it takes to see 3000 walls. Throws Error where a file is damaged.
double tile_spread(const HeightSource& dsm);

}  // namespace gable
