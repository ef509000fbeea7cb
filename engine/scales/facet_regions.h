#pragma once

#include <gable/engine/scales/first_shapes.h>

namespace gable {

/// find_first_shapes for a mesh: region growing over shared edges from the largest facets on. A
/// facet joins a region if all its corners lie within epsilon of the region's plane and its normal
/// within max_angle of the plane's. Facets without area belong to no shape. In meshes that are
/// rougher than epsilon (see mesh_noise; epsilon 0 is taken as it is), normals are those of the
/// surroundings, and shapes of fewer than min_inliers facets become part of an adjacent one.
FirstShapes grow_facet_regions(const Scan& scan, const FirstShapesOptions& options);

}  // namespace gable
