#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>
#include <gable/engine/reconstruct/choice/house_choice.h>

namespace gable {

/// A building with the solids that model files carry.
struct ReconstructedBuilding {
  Building building;
  BuildingModel model;
  HouseChoice choice;  ///< what the house was chosen from; empty where none was looked for
};

}  // namespace gable
