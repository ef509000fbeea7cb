#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/built_shape.h>

namespace gable {

/// Things on the roofs of a placed house that are no part of its derivation, as lifts in the world:
/// solar panels 0.1-0.2 m over a slope, vents and small stacks; on flat roofs parapets, hatches and
/// machines.
std::vector<BuiltPart> random_roof_clutter(const House& house, Random* random);

}  // namespace gable
