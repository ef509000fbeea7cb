#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

namespace gable {

/// Foundation and roofs of a random I, II or III. The blocks after the first are attached to an
/// earlier one as a cross wing (T), as a staggered or narrower neighbour, or as a lower extension.
/// May come out indistinct: the caller draws again until `is_distinct`.
House random_blocks(Foundation foundation, Random* random);

}  // namespace gable
