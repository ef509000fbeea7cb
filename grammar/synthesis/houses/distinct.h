#pragma once

#include <gable/grammar/house.h>

namespace gable {

/// Steps below this are not told apart in a height image of 0.5 m: two pixels, in metres.
inline constexpr double kDistinctStep = 1.0;
/// A flat block of a II or III at least this high; a lower one would be a garage. Metres.
inline constexpr double kFlatBlockHeight = 3.8;

/// Whether the foundation type can be seen in the heights: whether no other type makes nearly the
/// same surface. For the types of free blocks (II, III), of any two blocks that touch or overlap
///
///   1. each shows at least 12 m2 that the other does not cover, and
///   2. the plan steps at both ends of the wall they share by kDistinctStep (a T or a Z, which no
///      I, L or U can be), or eaves and highest points differ by kDistinctStep each, and
///   3. a flat block is at least kFlatBlockHeight high, or it would be a garage;
///
/// and all blocks hang together. For the types of one polygon (L, U): every wing stands out of the
/// others by 2 m in plan, U leaves 2 m between its wings, and eaves differ by 0.3 m at most.
/// An I is always distinct.
bool is_distinct(const House& house);

}  // namespace gable
