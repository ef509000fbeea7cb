#pragma once

#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// A height image turned into the house frame of a given azimuth: the place where rectangles are
/// searched. Cells are nearest samples; refinement never uses them, it turns the sample points.
struct RectifiedView {
  double azimuth = 0.0;  ///< radians, from local x to house x, anticlockwise
  double cell = 0.5;     ///< metres; columns along house x, rows along house y (row 0 lowest)
  double x0 = 0.0;       ///< house x of the left edge of column 0
  double y0 = 0.0;       ///< house y of the lower edge of row 0
  double spread = 0.0;   ///< HeightImage::spread, metres
  int rows = 0;
  int cols = 0;
  std::vector<float> height;
  std::vector<float> ground;
  std::vector<float> weight;
  std::vector<unsigned char> inside;

  size_t index(int row, int col) const { return static_cast<size_t>(row) * cols + col; }
  double x_edge(int col) const { return x0 + col * cell; }
  double y_edge(int row) const { return y0 + row * cell; }
};

/// Turns `image` by `azimuth` and keeps the box of its inside pixels with `margin` metres around.
/// Cells that fall outside the image get weight 0. An image without inside pixels gives no cells.
RectifiedView rectify(const HeightImage& image, double azimuth, double cell, double margin);

}  // namespace gable
