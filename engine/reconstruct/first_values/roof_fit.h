#pragma once

#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gable/grammar/wing_polygons.h>

#include <vector>

namespace gable {

/// A rectangle of cells of a rectified view: columns [col0, col1), rows [row0, row1).
struct CellRectangle {
  int col0 = 0, col1 = 0, row0 = 0, row1 = 0;
  int cols() const { return col1 - col0; }
  int rows() const { return row1 - row0; }
  bool operator==(const CellRectangle&) const = default;
};

/// The best roof over a rectangle of cells.
struct RoofFit {
  CellRectangle rectangle;
  Axis ridge = Axis::kX;
  bool flat = false;
  double eaves = 0.0;      ///< metres
  double rise = 0.0;       ///< metres
  double hip_start = 0.0;  ///< share of the length
  double hip_end = 0.0;
  double cost = 0.0;           ///< sum of squared robust residuals over the rectangle's cells
  double gain = 0.0;           ///< how much less that is than leaving the cells to the ground
  std::vector<float> heights;  ///< the roof at the rectangle's cells, row by row
  std::vector<float> gains;    ///< the gain by cell
};

/// Fits a flat roof and, with the ridge along `ridge`, gables and hips of equal pitch at either
/// end, by robust linear regression of the heights on the roof's shape, and returns the best. A
/// ridge costs `rise_penalty` over a flat roof, a hip as much over a gable (squared metres).
RoofFit fit_roof(const RectifiedView& view, const CellRectangle& rectangle, Axis ridge,
                 double loss_scale, double rise_penalty);

/// The fitted roof as a rule over its rectangle, the view's house frame. Ridges come as hips, of
/// which `simplify_roofs` makes gables.
RoofedRectangle roofed_rectangle(const RectifiedView& view, const RoofFit& fit);

}  // namespace gable
