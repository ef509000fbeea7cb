#pragma once

#include <gable/grammar/random.h>
#include <gable/training/scans/labelled_surface.h>

namespace gable {

/// A random flat-roofed building of 3 to 8 storeys over an I, L, U, T or Z. Hull: its walls and one
/// top; structure: storeys set back and lift housings too; detail: recesses of windows, balconies,
/// parapets.
LabelledSurface random_block_building_surface(Random* random);

}  // namespace gable
