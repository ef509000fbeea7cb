#pragma once

#include <gable/engine/scan.h>

#include <cstdint>

namespace gable {

/// A cloud of a gabled house with chimneys, its size and their number drawn from the seed, with
/// known planes: scale_1 every face, scale_2 without the chimneys' (they belong to the roof slope
/// below), scale_3 the roof as one.
Scan sample_house(uint64_t seed, int num_points = 6000);

}  // namespace gable
