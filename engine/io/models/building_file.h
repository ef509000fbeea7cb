#pragma once

#include <gable/engine/io/models/building.h>

#include <string>
#include <vector>

namespace gable {

/// Buildings read from a model file.
struct BuildingFile {
  std::vector<Building> buildings;  ///< in the order of the file
  int epsg = 0;                     ///< of the reference system, 0 where the file names none
};

/// Reads the buildings of a CityJSONSeq (.jsonl) or CityJSON file written by gable, from their
/// derivations; geometry is not read. Throws Error: kNoInput where the file cannot be opened;
/// kBadInput (with the line, for .jsonl) where it is malformed, not CityJSON, without a building,
/// or where a building has no derivation.
BuildingFile read_buildings(const std::string& path);

}  // namespace gable
