#include <gable/engine/io/building_model.h>

namespace gable {

const char* lod_name(Lod lod) {
  switch (lod) {
    case Lod::k12:
      return "1.2";
    case Lod::k20:
      return "2.0";
    default:
      return "2.2";
  }
}

const char* part_role_name(PartRole role) {
  switch (role) {
    case PartRole::kMain:
      return "main";
    case PartRole::kGarage:
      return "garage";
    case PartRole::kDormer:
      return "dormer";
    default:
      return "chimney";
  }
}

const Solid& finest_solid(const PartModel& part) { return part.solids.back().solid; }

}  // namespace gable
