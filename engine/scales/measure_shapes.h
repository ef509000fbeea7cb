#pragma once

#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scan.h>

#include <vector>

namespace gable {

/// What can be said of shapes and their planes: centroids, inliers, RMS distances and coverage.
/// shape_of: per element its shape, numbered from 0, or -1; `planes`: one per shape. Facets weigh
/// by their area. Normals are turned to the side that the elements' normals point to (of facets:
/// anticlockwise corners), or, in clouds without normals, up, then to +x, then +y. Polygons and
/// areas, and the number of the configuration, are left to the caller.
ScaleShapes measure_shapes(const Scan& scan, const std::vector<int>& shape_of,
                           const std::vector<OrientedPlane>& planes);

}  // namespace gable
