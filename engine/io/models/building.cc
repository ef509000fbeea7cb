#include <gable/engine/io/models/building.h>

namespace gable {

const char* building_status_name(BuildingStatus status) {
  switch (status) {
    case BuildingStatus::kGrammar:
      return "grammar";
    case BuildingStatus::kPlanes:
      return "planes";
    default:
      return "extrusion";
  }
}

}  // namespace gable
