#pragma once

#include <gable/engine/scales/first_shapes.h>

namespace gable {

/// find_first_shapes for a mesh: region growing over shared edges from the largest facets on. A
/// facet joins a region if all its corners lie within epsilon of the region's plane and its normal
/// within max_angle of the plane's. Facets without area belong to no shape.
FirstShapes grow_facet_regions(const Scan& scan, const FirstShapesOptions& options);

}  // namespace gable
