#pragma once

#include <string>
#include <vector>

#include <gable/grammar/house.h>
#include <gable/grammar/solid/solid.h>

namespace gable {

/// Levels of detail, made by dropping nodes of the derivation: 1.2 has flat-topped blocks, 2.0 the
/// main roofs and garages, 2.2 dormers and chimneys as well.
enum class Lod { k12, k20, k22 };

/// What a part of a house stands for.
enum class PartRole { kMain, kGarage, kDormer, kChimney };

/// One closed solid of a house, in the local frame (world less House::origin), metres.
struct HousePart {
  PartRole role = PartRole::kMain;
  int index = 0;  ///< which garage, dormer or chimney of the House; for kMain, which of the
                  ///< separate bodies that the components form, in order of their first component
  Solid solid;
};

struct HouseSolids {
  std::vector<HousePart> parts;
  /// Rules that show nothing (a garage wholly under the roof, a chimney inside the attic) or whose
  /// solid could not be built, one line each.
  std::vector<std::string> dropped;
};

/// The solids of a house at a level of detail. The main body is the upper envelope of the
/// components' roofs down to `base` (metres above House::origin, usually <= 0); components that
/// touch form one solid. A garage is the part of its polygon outside the main body (and earlier
/// garages), a dormer or chimney what stands out of the envelope below it, closed by a bottom face.
HouseSolids build_house_solids(const House& house, Lod lod, double base);

}  // namespace gable
