#pragma once

#include <gable/grammar/raster.h>

namespace gable {

/// Options of `derive_terrain`. Lengths and heights in metres.
struct TerrainOptions {
  /// Widest object that is removed, in (1, 1000]: wider buildings are taken for ground.
  double max_object_width = 60.0;
  /// How fast the ground may rise beyond the raster's overall slope and curvature, in [0, 2].
  double slope = 0.1;
  /// Height above the opened surface from which on a cell is an object at the smallest window, in
  /// (0, 5]; grows with the window's width times `slope`.
  double min_object_height = 0.3;
  /// Largest value that this threshold grows to, at least min_object_height.
  double max_threshold = 2.0;
  /// Standard deviation of the final Gaussian smoothing, in [0, 20].
  double smoothing = 1.0;

  /// Throws Error (kUsage) that names the violated bound.
  void check() const;
};

/// Bare terrain under a surface raster, by a progressive morphological filter (Zhang et al. 2003):
/// openings with growing windows; a cell is an object where the next opening lowers it by more than
/// a threshold that grows with the window. The raster's overall shape (a quadratic fitted to the
/// lowest cells) is taken off first, so that hillsides are no objects. Objects and nodata are
/// filled smoothly from the ground around. The result has a height in every cell (none where `dsm`
/// has none at all) and is never above `dsm`. Cells of 0.25 to 1 m are what it is made for.
HeightRaster derive_terrain(const HeightRaster& dsm, const TerrainOptions& options = {});

}  // namespace gable
