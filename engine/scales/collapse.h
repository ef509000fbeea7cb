#pragma once

#include <gable/engine/scales/trajectory.h>

namespace gable {

/// Merges adjacent shapes, cheapest pair first, until none are adjacent (CVPR 2018, section 4). The
/// price of a pair is the RMS distance of its united elements to their best plane (eq. 1), read off
/// united moments, so that a merge costs the adjacent shapes and never the elements. Ties go to the
/// lower numbers. The features of every configuration are kept as well (section 5).
Trajectory collapse(const FirstShapes& first);

}  // namespace gable
