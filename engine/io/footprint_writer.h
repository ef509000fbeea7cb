#pragma once

#include <gable/engine/io/crs.h>
#include <gable/grammar/solid/extrusion.h>

#include <string>
#include <vector>

namespace gable {

/// A building's outline as a vector file carries it.
struct Footprint {
  std::string id;
  PlanPolygon polygon;  ///< world frame, metres
};

/// Writes outlines as a GeoPackage with one layer "footprints" and a text field "id". Atomic; the
/// same outlines give the same bytes. Throws Error (kCannotWrite).
void write_footprints(const std::string& path, const std::vector<Footprint>& footprints,
                      const Crs& crs);

}  // namespace gable
