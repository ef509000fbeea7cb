#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// A building that no derivation of the grammar describes, in its own frame as `random_house`
/// gives it: four to six blocks under roofs of their own, as a House of foundation kC with one
/// footprint and one roof a block. Not well formed, but with a height field and an outline.
House random_composite(Random* random);

}  // namespace gable
