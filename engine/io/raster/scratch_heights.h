#pragma once

#include <gable/engine/io/raster/height_source.h>
#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace gable {

/// Heights that are kept in a file without a name, so that they take no memory and, however the
/// program ends, nothing of them is left behind. Without a height until they are written.
class ScratchHeights : public HeightSource {
 public:
  /// `path` is for messages. The file lies in `folder`; empty: the system's folder for temporary
  /// files. Throws Error (kCannotWrite).
  ScratchHeights(const Grid& grid, const Crs& crs, const std::string& path,
                 const std::string& folder);
  ~ScratchHeights() override;
  ScratchHeights(const ScratchHeights&) = delete;
  ScratchHeights& operator=(const ScratchHeights&) = delete;

  const std::string& path() const override { return path_; }
  const Grid& grid() const override { return grid_; }
  const Crs& crs() const override { return crs_; }
  HeightRaster read(int row0, int col0, int rows, int cols) const override;
  std::vector<Grid> tiles() const override {
    return tiles_.empty() ? HeightSource::tiles() : tiles_;
  }

  /// Says what `tiles` gives: where heights are written.
  void set_tiles(std::vector<Grid> tiles) { tiles_ = std::move(tiles); }
  /// Writes the cells of `heights` from (row, col) on, which must lie inside grid(). NaN takes a
  /// height away. Throws Error (kCannotWrite), for instance on a full disk.
  void write(const HeightRaster& heights, int row, int col);

 private:
  [[noreturn]] void fail(int error_number) const;
  off_t place_of(int row, int col) const;

  Grid grid_;
  Crs crs_;
  std::string path_, folder_;
  std::vector<Grid> tiles_;
  int descriptor_ = -1;
};

}  // namespace gable
