#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

namespace gable {

/// The rectangular houses (I) that towns are full of, in their own frame as `random_house` gives
/// them.
enum class PlainKind {
  kHouse,     ///< 6-10 x 7-20 m, mostly gabled; detached, or a pair under one roof
  kTerrace,   ///< 20-40 m under one ridge
  kOuthouse,  ///< sheds and garages of 2.6-4.5 x 3-8 m, up to 3.5 m high, flat or gabled;
              ///< at least 4.5 cells of `gsd` metres wide
};

House random_plain_house(PlainKind kind, double gsd, Random* random);

/// Tilts the flat roof of a shape of one block by up to 14 degrees about its middle: such a shed is
/// flat to the grammar.
void tilt_flat_roof(Random* random, BuiltShape* shape);

}  // namespace gable
