#pragma once

#include <gable/engine/scales/outline/outlined_region.h>

#include <opencv2/core.hpp>
#include <vector>

namespace gable {

/// The alpha hull of the marked pixels of a raster: what no disc of radius `radius` (pixels) that
/// holds no mark can reach, which is the closing of the marks with that disc (Edelsbrunner,
/// Kirkpatrick, Seidel 1983). Found with two Euclidean distance transforms, traced by marching
/// squares between pixels. Coordinates are pixels: (column, row), pixel centres at integers, and
/// anticlockwise is from columns to rows.
///
/// `mask` is 8-bit, marks are not 0 and keep ceil(radius) + 2 pixels clear of the border. The
/// outlines are drawn in by `inset` pixels; regions nowhere wider than about 2 pixels go. Rings are
/// simplified by `tolerance` pixels and simple.
std::vector<OutlinedRegion> outlines_of_closing(const cv::Mat& mask, double radius, double inset,
                                                double tolerance);

}  // namespace gable
