#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <ogr_geometry.h>

namespace gable {

/// A polygon of the plan as GDAL's, rings closed, coordinates as they are.
OGRPolygon ogr_polygon(const PlanPolygon& polygon);

}  // namespace gable
