#pragma once

#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scales/report/axonometric_view.h>
#include <gable/engine/scan.h>

#include <opencv2/core.hpp>
#include <span>
#include <vector>

namespace gable {

/// The polygons of shapes in space, 8-bit BGR on white, of the view's size: a colour per shape, lit
/// by its normal, with dark outlines. Shapes without polygons are not seen. `numbers`: per shape
/// the number that its colour is of; none: its place.
cv::Mat draw_shapes(std::span<const PlanarShape> shapes, const AxonometricView& view,
                    std::span<const int> numbers = {});

/// The elements of a scan in the colours of their shapes: points as discs that close up to
/// surfaces, facets as they are. `shape_of` per element, -1 for none (pale grey, points small).
/// Every shape of a cloud is lit by the one plane through its points.
cv::Mat draw_elements(const Scan& scan, std::span<const int> shape_of, const AxonometricView& view);

/// A scan without shapes: grey, lit by the normals of its facets or (where known) points.
cv::Mat draw_scan(const Scan& scan, const AxonometricView& view);

}  // namespace gable
