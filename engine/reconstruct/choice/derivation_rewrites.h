#pragma once

#include <gable/grammar/house.h>

#include <vector>

namespace gable {

/// When two derivations say nearly the same.
struct RewriteOptions {
  double alignment = 1.0;      ///< edges this near count as one, metres, > 0
  double garage_height = 3.8;  ///< a flat block lower than this is a garage, metres
};

/// Other derivations of nearly the same surface, for the penalised cost to judge after a short
/// refinement: two blocks that form an L, three that form a U, a low flat block as a garage.
/// Searches place II and III more freely than L and U, and a better basin found by one type serves
/// the other this way.
std::vector<House> rewrites(const House& house, const RewriteOptions& options);

/// Dormers stand on a component by number; after components have changed, puts each on the highest
/// under its centre, and takes those away that have none.
void reassign_dormers(House* house);

}  // namespace gable
