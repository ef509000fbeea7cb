#pragma once

#include <gable/engine/solver/neighbour_relations.h>

#include <vector>

namespace gable {

/// The groups of houses that party walls connect, of two houses and more, positions of houses
/// inside. A group of more than `most` is cut: it is walked breadth first from the house with the
/// fewest neighbours (the end of a row) and cut after every `most` houses. Groups in the order of
/// their first houses, houses in that of the walk; ties go to the lower position, so the same
/// relations give the same groups.
std::vector<std::vector<int>> neighbour_groups(int num_houses,
                                               const std::vector<NeighbourRelation>& relations,
                                               int most);

}  // namespace gable
