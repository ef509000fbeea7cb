#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <cstdint>

namespace gable {

/// A random building with its CityGML levels of detail as scales: detail LOD3, structure LOD2, hull
/// LOD1. Two in three are houses of the grammar's prior (random_house_surface), the others
/// flat-roofed blocks (random_block_building_surface). Metres, z up, over flat ground at 0, no
/// underside.
LabelledSurface random_building(uint64_t seed);

}  // namespace gable
