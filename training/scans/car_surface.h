#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <cstdint>

namespace gable {

/// A random car, front to -x, standing on z = 0, metres. Detail: bonnet, windscreens, roof and boot
/// of many strips, bumpers, lights, side windows, wheels and their arches, mirrors; structure:
/// front, bonnet, windscreen, roof, rear window, boot, rear, sides and side windows, underbody;
/// hull: front, bonnet with windscreen, roof, rear window with boot, rear, each side as one.
LabelledSurface random_car(uint64_t seed);

}  // namespace gable
