#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// Adds one or two flat garages, a fifth of them L-shaped: 2.2-3.2 m high, at least 0.4 m below the
/// eaves of the wall they stand at, outside all components, more than half of one side in contact
/// with that wall. Adds none where there is no room.
void add_garages(Random* random, House* house);

}  // namespace gable
