#pragma once

#include <gable/engine/io/models/building.h>

#include <cstddef>
#include <string>

namespace gable {

/// What the report's page says about one building.
struct HouseEntry {
  size_t index = 0;  ///< place in the report
  std::string id;
  std::string status;  ///< see building_status_name
  std::string reason;
  std::string foundation;  ///< "C" outside the grammar
  std::string roofs;       ///< "gable, hip"; empty outside the grammar
  size_t dormers = 0;
  size_t chimneys = 0;
  size_t garages = 0;
  FitQuality quality;
  std::string picture;  ///< path of the picture relative to the page
};

}  // namespace gable
