#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <cstdint>

namespace gable {

/// A random furnished room seen from inside, metres, floor at z = 0. Detail: drawers, handles,
/// legs, books, screens, frames of doors and windows; structure: the main faces of furniture, and
/// floor, walls and ceiling; hull: floor, walls, ceiling and large pieces of furniture as one
/// plane.
LabelledSurface random_indoor_scene(uint64_t seed);

}  // namespace gable
