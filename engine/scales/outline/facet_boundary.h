#pragma once

#include <gable/engine/scales/outline/outlined_region.h>

#include <optional>
#include <vector>

namespace gable {

/// The union of polygons of the plane by their boundary: the edges that no other polygon has in the
/// opposite direction. Polygons may turn either way round and share corners of exactly the same
/// coordinates. Nothing where the boundary alone does not tell: where polygons overlap, touch at
/// single corners, or have no area.
///
/// Each boundary ring being simple and clear of the others, the number of polygons that cover a
/// point is the number of rings around it, holes counted negative; that it is 0 outside and 1
/// inside is checked, so what is returned is exact.
std::optional<std::vector<OutlinedRegion>> union_by_boundary(const std::vector<Ring>& polygons);

}  // namespace gable
