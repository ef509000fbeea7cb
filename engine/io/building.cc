#include <gable/engine/io/building.h>

namespace gable {

const char* building_status_name(BuildingStatus status) {
  return status == BuildingStatus::kGrammar ? "grammar" : "extrusion";
}

}  // namespace gable
