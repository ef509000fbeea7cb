#pragma once

#include <gable/engine/scales/refit_shapes.h>
#include <gable/engine/scales/report/scales_report.h>

namespace gable {

/// How far the planes that a refit tied together (parallel, coplanar, orthogonal, horizontal,
/// vertical) miss that, before and after it: mean angles in degrees, NaN where it tied none.
RegularityAngles regularity_angles(const PlaneRefit& refit);

}  // namespace gable
