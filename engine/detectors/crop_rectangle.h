#pragma once

namespace gable {

/// An axis-aligned rectangle of a crop, crop pixels: x to the right, y down.
struct CropRectangle {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;

  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
};

}  // namespace gable
