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

/// A part of a building with its solids, coarse to fine. A dormer or chimney has LoD 2.2 only.
struct PartModel {
  PartRole role = PartRole::kMain;
  int index = 0;  ///< see HousePart::index
  int piece = 0;  ///< counts the solids that one garage, dormer or chimney falls into
  std::vector<LodSolid> solids;
};

/// The solids of a building as model files carry them.
struct BuildingModel {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world
  std::vector<PartModel> parts;                      ///< main bodies, garages, dormers, chimneys
  std::vector<std::string> dropped;  ///< rules that show nothing at LoD 2.2, one line each
};

/// "1.2", "2.0" or "2.2".
const char* lod_name(Lod lod);

/// "main", "garage", "dormer" or "chimney".
const char* part_role_name(PartRole role);

/// The finest solid of a part.
const Solid& finest_solid(const PartModel& part);

}  // namespace gable
