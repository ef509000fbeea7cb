#pragma once

#include <gable/grammar/solid/house_solids.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace gable {

/// One closed solid of a part at one level of detail, local frame (world less the origin), metres.
struct LodSolid {
  Lod lod = Lod::k22;
  Solid solid;
};

/// A part of a building with its solids, coarse to fine. A dormer or chimney has LoD 2.2 and 2.3
/// only, a roof slab 2.3 only.
struct PartModel {
  PartRole role = PartRole::kMain;
  int index = 0;  ///< see HousePart::index
  int piece = 0;  ///< counts the solids that one garage, dormer or chimney falls into
  std::vector<LodSolid> solids;
};

/// The solids of a building as model files carry them.
struct BuildingModel {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world
  std::vector<PartModel> parts;                      ///< main bodies, garages, dormers, chimneys,
                                                     ///< roof slabs
  std::vector<std::string> dropped;  ///< rules that show nothing at LoD 2.2, one line each
};

/// "1.2", "2.0", "2.2" or "2.3".
const char* lod_name(Lod lod);

/// "main", "garage", "dormer", "chimney" or "roof".
const char* part_role_name(PartRole role);

/// What files call a part: "garage-2", or "garage-2-3" for its third piece.
std::string part_name(const PartModel& part);

/// The finest solid of a part: what is drawn.
const Solid& finest_solid(const PartModel& part);

/// The finest solid of a part as it was fitted, without roof slabs; null for a roof slab.
const Solid* finest_solid_without_slabs(const PartModel& part);

/// The class that a face of a part is drawn as: its own, but the underside of a roof slab is no
/// ground and drawn as a wall.
SurfaceType drawn_type(PartRole role, SurfaceType type);

}  // namespace gable
