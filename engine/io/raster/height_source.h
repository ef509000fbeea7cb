#pragma once

#include <gable/engine/io/crs.h>
#include <gable/grammar/raster.h>

#include <string>
#include <vector>

namespace gable {

/// Heights on a north-up grid of square cells in projected metres that are read window by window,
/// whatever they are kept in.
class HeightSource {
 public:
  virtual ~HeightSource() = default;

  /// For messages.
  virtual const std::string& path() const = 0;
  virtual const Grid& grid() const = 0;
  virtual const Crs& crs() const = 0;

  /// The cells [row0, row0 + rows) x [col0, col0 + cols), which must lie inside grid(). Metres; NaN
  /// where there is no height. Safe from several threads. Throws Error (kBadInput) where a file is
  /// damaged.
  virtual HeightRaster read(int row0, int col0, int rows, int cols) const = 0;

  /// The parts of grid() outside which no cell has a height.
  virtual std::vector<Grid> tiles() const { return {grid()}; }

  /// The heights at the cell centres of another grid of the same CRS, see `resample_bilinear`. Only
  /// the part under that grid is read.
  HeightRaster read_onto(const Grid& target) const;

 protected:
  HeightSource() = default;
  HeightSource(const HeightSource&) = default;
  HeightSource& operator=(const HeightSource&) = default;
};

/// Whether there is a height at all. Reads strips of `strip_rows` rows, [1, inf), up to the first
/// one.
bool holds_height(const HeightSource& source, int strip_rows);

/// Checks that a terrain can be used with a surface: same horizontal CRS, extents that overlap.
/// Throws Error (kBadInput) that names both files.
void require_matching(const HeightSource& dsm, const HeightSource& dtm);

}  // namespace gable
