#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// Adds one or two dormers with flat roofs, 2-4 m wide, to one slope of a component: their fronts
/// stand 1.0 m or more out of the slope, their tops end 0.2-1.0 m below the ridge where they die
/// into it. Adds none where no slope has room, or slopes are below 30 degrees.
void add_box_dormers(Random* random, House* house);

}  // namespace gable
