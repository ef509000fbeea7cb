#pragma once

#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace gable {

/// The boundaries that a city model holds of one building or part of a building.
struct CityJsonObject {
  std::string id;
  /// The frame of the solids: their vertices are relative to this point of the file's reference
  /// system, metres.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /// By level of detail, as written ("1.2", "2.2"). Rings and faces are taken as they are; they may
  /// be neither planar nor closed.
  std::map<std::string, Solid> solids;
};

/// Reads the solids and surfaces of a CityJSON file (1.0, 1.1 or 2.0), in the order of the file:
/// every object with geometry of type Solid (outer shells), MultiSurface or CompositeSurface.
/// Vertices at one place become one, repeated corners of a ring go; rings of less than three
/// corners are left out. Faces without a semantic type get one from their normal. Throws Error:
/// kNoInput where the file cannot be opened, kBadInput where it is no CityJSON or malformed.
std::vector<CityJsonObject> read_cityjson_solids(const std::string& path);

}  // namespace gable
