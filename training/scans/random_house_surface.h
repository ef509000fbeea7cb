#pragma once

#include <gable/grammar/random.h>
#include <gable/training/scans/labelled_surface.h>

namespace gable {

/// The surface (house_surface) of a random derivation of the prior, on higher walls and under
/// flatter roofs than the prior's, a third to five sixths as steep: what merging by RMS distance
/// can take to LOD1 (see random_house_surface.cc).
LabelledSurface random_house_surface(Random* random);

}  // namespace gable
