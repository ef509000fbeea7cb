#pragma once

#include <gable/training/scans/car_shape.h>
#include <gable/training/scans/surface_builder.h>

namespace gable {

/// Adds one side of a car: body with wheel arches, side windows, wheels, handles and mirror. Two
/// planes of the structure (body, windows), one of the hull. Sets the builder's pose to identity.
void add_car_side(const CarShape& car, bool left, SurfaceBuilder* builder);

}  // namespace gable
