#pragma once

#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scales/report/axonometric_view.h>
#include <gable/engine/scan.h>

#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace gable {

/// The polygons of shapes in space, 8-bit BGR on white, of the view's size: a colour per shape, lit
/// by its normal, with dark outlines. Shapes without polygons are not seen.
cv::Mat draw_shapes(std::span<const PlanarShape> shapes, const AxonometricView& view);

/// The elements of a scan in the colours of their shapes: points as discs that close up to
/// surfaces, facets as they are. `shape_of` per element, -1 for none (pale grey, points small).
/// Every shape is lit by the one plane through its elements.
cv::Mat draw_elements(const Scan& scan, std::span<const int> shape_of, const AxonometricView& view);

}  // namespace gable
