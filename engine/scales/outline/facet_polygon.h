#pragma once

#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scan.h>

#include <span>
#include <vector>

namespace gable {

/// The union of facets of a mesh projected onto a plane, as polygons that lie on it, largest first,
/// with simple rings. Exact where the projected facets meet at their edges alone. Where they
/// overlap or are degenerate, outlined on a raster instead: of 1/200 to 1/600 of their extent, the
/// finer the more facets there are. Facets that are edge-on have no part in it.
std::vector<SpacePolygon> facet_polygons(const Scan& mesh, std::span<const int> facets,
                                         const OrientedPlane& plane);

}  // namespace gable
