#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/known_outline.h>
#include <gable/grammar/solid/solid.h>

#include <string>
#include <vector>

namespace gable {

/// Levels of detail, made by dropping nodes of the derivation: 1.2 has the components and garages
/// with flat tops (a roof's at two thirds of its rise above the eaves), 2.0 the main roofs and
/// garages, 2.2 dormers and chimneys as well, 2.3 roofs with thickness and overhang (roof_slabs.h).
enum class Lod { k12, k20, k22, k23 };

/// What a part of a house stands for.
enum class PartRole { kMain, kGarage, kDormer, kChimney, kRoofSlab };

/// One closed solid of a house, in the local frame (world less House::origin), metres.
struct HousePart {
  PartRole role = PartRole::kMain;
  int index = 0;  ///< which garage, dormer or chimney of the House; for kMain, which of the
                  ///< separate bodies that the components form, in order of their first component;
                  ///< for kRoofSlab, which of all slabs
  Solid solid;
};

struct HouseSolids {
  std::vector<HousePart> parts;
  /// Rules that show nothing (a garage wholly under the roof, a chimney inside the attic) or whose
  /// solid could not be built, one line each.
  std::vector<std::string> dropped;
};

/// The solids of a house at a level of detail up to 2.2. The parts stand on one another in the
/// order main, garages, dormers, chimneys: each is what its own blocks show above the upper
/// envelope of all earlier ones, and reaches down to `base` (metres above House::origin, usually <=
/// 0) where none of those stands. So parts do not overlap, and together they fill exactly the
/// height field at support 0 above `base`.
///
/// Components that touch in more than an edge form one solid. A garage, dormer or chimney can fall
/// into several parts of one index (a chimney cut by a garage roof, say). Bodies of less than 5
/// litres are left out. Where a part rests on a roof its lower faces are ground surfaces.
///
/// Nearly coincident edges (2 cm) and heights (1 cm) are made equal, see BlockAlignment. Where a
/// part would still not be valid, its blocks are moved by millimetres, at most 2.6 cm, until it is;
/// main roofs that resist get flat tops and a line in `dropped`. Every solid passes check_solid,
/// before and after rounding its vertices to 0.1 mm. Deterministic.
///
/// `outline`: a known outline that the house fills (OutlinedHouse), local frame; empty: none.
/// Solids without it are valid more surely: an outline may touch the blocks in features too fine to
/// build.
HouseSolids build_house_solids(const House& house, Lod lod, double base,
                               const KnownOutline& outline = {});

}  // namespace gable
