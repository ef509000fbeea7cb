#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// Adds one to three dormers of one size in a row on one slope, where there is room: wholly inside
/// the plane of the slope, clear of other components, standing 0.9-1.5 m out of it at their front.
/// Adds none where no slope is large enough.
void add_dormers(Random* random, House* house);

/// Adds one or two chimneys at gable ends, on the ridge or beside it, inside the footprint and
/// clear of dormers, rising 0.8-2.0 m over the highest point of the roof under them.
void add_chimneys(Random* random, House* house);

}  // namespace gable
