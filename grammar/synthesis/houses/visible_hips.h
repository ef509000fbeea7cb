#pragma once

#include <gable/grammar/house.h>

namespace gable {

/// Makes gables of the hips whose run is below `least_run` metres: coarse cells, which smear walls,
/// show these alike. With an infinite `least_run` all hips of the house become gables.
void drop_short_hips(double least_run, House* house);

}  // namespace gable
