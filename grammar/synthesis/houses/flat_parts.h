#pragma once

#include <gable/grammar/house.h>

namespace gable {

/// A flat part of a II or III shows at least this much of itself, in plan. Square metres.
inline constexpr double kFlatPartArea = 8.0;

/// Whether the flat components after the first of a II or III can be told from a first one of any
/// roof, as flat shelves of terraced houses are, where `is_distinct` asks for steps of the plan or
/// of the eaves: each
///
///   1. shows kFlatPartArea that no other covers, and the first shows 12 m2,
///   2. is kFlatBlockHeight high or higher, and
///   3. lies kDistinctStep or more below the highest point of the first, and as far from any other.
///
/// Eaves may be equal: a level plane beside a slope is seen by its normals. False where a later
/// component is not flat.
bool flat_parts_are_distinct(const House& house);

}  // namespace gable
