#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/prior.h>

namespace gable {

/// A house of the given type (not kC) in its own frame as `random_house` gives it, but of a wider
/// variety: some of the prior as it is, the others larger or smaller, steeper or shallower (15-60
/// degrees), higher or lower (eaves from 2.2 to 9 m); flat I; porches and lean-tos as garages;
/// dormers with flat roofs. Every parameter lies within the bounds of parameter_specs, and
/// `is_distinct` holds. `options.max_diagonal` is that of the components alone.
House random_training_house(Foundation foundation, Random* random, const PriorOptions& options);

}  // namespace gable
