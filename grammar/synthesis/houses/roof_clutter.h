#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

namespace gable {

/// Adds to the shape of a placed house, world, what is no part of its derivation: solar panels
/// 0.1-0.2 m over a slope, vents and small stacks; on flat roofs parapets, hatches and machines,
/// all as lifts; eaves that hang over by up to 0.3 m; bays of 0.3-0.9 m depth at a wall, below the
/// eaves. `shape` is `shape_of(house)`.
void add_roof_clutter(const House& house, Random* random, BuiltShape* shape);

}  // namespace gable
