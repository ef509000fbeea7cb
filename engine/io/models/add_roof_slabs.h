#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>
#include <gable/grammar/solid/roof_slabs.h>

namespace gable {

/// Gives a house's model roofs with thickness and overhang (LoD 2.3): slabs as parts of their own,
/// and for every other part a solid that ends under them. LoD 2.2 and coarser stay as they are.
/// Buildings that are no houses of the grammar stay as they are too. What could not be built gets a
/// line in `model->dropped` and in `building->reason`. `neighbours`: outlines of other buildings,
/// world frame, metres, that overhangs end at.
void add_roof_slabs(const RoofSlabOptions& options, const std::vector<PlanPolygon>& neighbours,
                    Building* building, BuildingModel* model);

}  // namespace gable
