#pragma once

#include <gable/engine/io/building.h>
#include <gable/engine/io/building_model.h>

namespace gable {

/// Builds the solids of a building: LoD 1.2, 2.0 and 2.2 of a house; LoD 1.2, the outline at
/// one height, of everything else, and 2.0 and 2.2, which are the same, where there is a roof.
BuildingModel build_model(const Building& building);

}  // namespace gable
