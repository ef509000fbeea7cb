#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <cstdint>

namespace gable {

/// A random sofa or armchair, front to -y, z up, metres, without its underside. Detail: every strip
/// of rounded edges, each cushion, legs; structure: seat, front, back with its top and rear, and of
/// each arm inside, top, outside and front; hull: seat, back, rear and each arm as one.
LabelledSurface random_sofa(uint64_t seed);

}  // namespace gable
