#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/solid.h>

namespace gable {

/// A polygon of the local frame (world less House::origin) in the frame of a house with this
/// azimuth (radians), whose blocks lie along its axes.
PlanPolygon house_from_local(PlanPolygon polygon, double azimuth);

/// Turns a solid from the frame of a house with this azimuth (radians) into the local frame.
void turn_to_local(double azimuth, Solid* solid);

}  // namespace gable
