#pragma once

#include <gable/engine/io/models/building_model.h>

#include <string>

namespace gable {

/// Why the solids of a house cannot be used (no body, a part without a valid solid), or "".
std::string defect_of(const BuildingModel& model);

}  // namespace gable
