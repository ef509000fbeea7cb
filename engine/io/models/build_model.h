#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>

#include <array>
#include <span>

namespace gable {

/// The levels of detail of a house.
inline constexpr std::array<Lod, 3> kHouseLods = {Lod::k12, Lod::k20, Lod::k22};

/// Builds the solids of a building: a house at `lods`, coarse to fine; LoD 1.2, the outline at one
/// height, of everything else, and 2.0 and 2.2, which are the same, where there is a roof.
BuildingModel build_model(const Building& building, std::span<const Lod> lods = kHouseLods);

}  // namespace gable
