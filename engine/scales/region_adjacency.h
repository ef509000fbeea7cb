#pragma once

#include <gable/engine/scales/neighbours.h>

#include <utility>
#include <vector>

namespace gable {

/// Pairs (a, b), a < b, sorted, of regions that have mutual nearest neighbours in each other (CVPR
/// 2018, section 4). region_of: per point, -1 for none.
std::vector<std::pair<int, int>> adjacent_regions(const Neighbours& neighbours,
                                                  const std::vector<int>& region_of, int threads);

}  // namespace gable
