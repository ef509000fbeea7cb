#include "examples/cli/model_input.h"

#include <gable/engine/error.h>
#include <gable/engine/io/models/building_file.h>

#include <utility>

namespace gable {

std::vector<Building> read_models(const std::string& path, const RasterFile& dsm) {
  BuildingFile file = read_buildings(path);
  if (file.epsg != 0 && dsm.crs().epsg != 0 && file.epsg != dsm.crs().epsg) {
    throw Error(ExitCode::kBadInput, path + ": is in EPSG:" + std::to_string(file.epsg) + ", but " +
                                         dsm.path() + " in EPSG:" + std::to_string(dsm.crs().epsg) +
                                         "; reproject one of them");
  }
  return std::move(file.buildings);
}

}  // namespace gable
