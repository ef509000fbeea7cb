#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace gable {

/// A box of pixels, half-open.
struct PixelBox {
  int row0 = 0, row1 = 0, col0 = 0, col1 = 0;
};

/// Pixels that hang together.
struct PixelRegion {
  std::vector<size_t> pixels;  ///< row * cols + column, ascending
  PixelBox box;
};

/// The regions of a mask's pixels other than 0 (CV_8U), connected over edges and corners, in the
/// order of their first pixels.
std::vector<PixelRegion> connected_regions(const cv::Mat& mask);

/// The same, larger ones first.
std::vector<PixelRegion> largest_regions(const cv::Mat& mask);

}  // namespace gable
