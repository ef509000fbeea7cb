#pragma once

#include <gable/engine/scales/trajectory.h>

namespace gable {

/// Unites every shape of fewer than `min_inliers` elements, smallest first, with the adjacent shape
/// with which it is nearest to one plane, until none is left that has a neighbour. Shapes are
/// numbered anew in the order of their lowest first shapes.
void absorb_small_shapes(int min_inliers, FirstShapes* first);

}  // namespace gable
