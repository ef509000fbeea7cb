#pragma once

#include <gable/engine/reconstruct/scan/wall_traces.h>

#include <vector>

namespace gable {

/// Per sample whether it belongs to a roof that juts out over a wall: up to `reach`, metres,
/// outside the stretch seen of it, and not lower than `reach` under its top; or around the corner
/// of two such walls. The outside of a wall is where there is little roof beyond that; a wall with
/// as much or as little on both sides has none, and neither has one in front of which another one
/// stands. Samples without a shape or on walls themselves are none. `is_roof`: per shape.
std::vector<bool> find_overhangs(const std::vector<SurfaceSample>& samples,
                                 const std::vector<bool>& is_roof,
                                 const std::vector<WallTrace>& walls, double reach);

}  // namespace gable
