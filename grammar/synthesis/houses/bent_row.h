#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

namespace gable {

/// A long building beyond the grammar, in its own frame: two to five stretches of 7-22 m, each
/// turned against the one before by 15-40 degrees (the second always), by 80-100, or set off to one
/// side, under one or several heights, with wings and low parts at the back; or, where
/// `largest` is above 45, four to seven houses with narrower and lower links between them; turned
/// at random, middle at the origin. The box around it has a diagonal of `largest` metres at most,
/// which is 30 or more.
BuiltShape random_bent_row(double largest, Random* random);

}  // namespace gable
