#pragma once

#include <gable/engine/scales/first_shapes.h>

namespace gable {

/// find_first_shapes for a cloud: region growing (Rabbani et al., as in CVPR 2018, section 4) from
/// the flattest points on. A point joins a region through its nearest neighbours if it lies within
/// epsilon of the region's plane and its normal within max_angle of the plane's.
FirstShapes grow_point_regions(const Scan& scan, const FirstShapesOptions& options);

}  // namespace gable
