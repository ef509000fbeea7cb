#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// Foundation and roofs of a random L: both wings share eaves and pitch. At the corner the roofs
/// are mitred (a hip as steep as the sides at both wings), or one wing runs through to a gable and
/// the other dies into it, or, rarely, both end in gables.
House random_l(Random* random);

/// The same for a U: base and two wings.
House random_u(Random* random);

}  // namespace gable
