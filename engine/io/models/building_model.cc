#include <gable/engine/io/models/building_model.h>

namespace gable {

const char* lod_name(Lod lod) {
  switch (lod) {
    case Lod::k12:
      return "1.2";
    case Lod::k20:
      return "2.0";
    case Lod::k22:
      return "2.2";
    default:
      return "2.3";
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
    case PartRole::kChimney:
      return "chimney";
    default:
      return "roof";
  }
}

std::string part_name(const PartModel& part) {
  std::string name = std::string(part_role_name(part.role)) + "-" + std::to_string(part.index + 1);
  if (part.piece > 0) name += "-" + std::to_string(part.piece + 1);
  return name;
}

const Solid& finest_solid(const PartModel& part) { return part.solids.back().solid; }

const Solid* finest_solid_without_slabs(const PartModel& part) {
  const Solid* finest = nullptr;
  for (const LodSolid& solid : part.solids) {
    if (solid.lod != Lod::k23) finest = &solid.solid;
  }
  return finest;
}

SurfaceType drawn_type(PartRole role, SurfaceType type) {
  return role == PartRole::kRoofSlab && type == SurfaceType::kGround ? SurfaceType::kWall : type;
}

}  // namespace gable
