#pragma once

#include <gable/engine/io/raster/raster_file.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gable {

/// Raster files side by side as one: their cells lie on one common grid, each file covers a part of
/// it. Where files overlap, the first one that has a height counts. Only a few files are open at
/// once, so there may be any number of them.
class RasterMosaic : public HeightSource {
 public:
  /// At least one path. Throws Error as RasterFile does for each file, and kBadInput, naming the
  /// file and the remedy, where a file's CRS or cell size differs from the first one's, where its
  /// cells lie between those of the first one, or where no file holds a height.
  explicit RasterMosaic(const std::vector<std::string>& paths,
                        const RasterFileOptions& options = {});

  const std::string& path() const override { return name_; }
  const Grid& grid() const override { return grid_; }
  const Crs& crs() const override { return crs_; }
  HeightRaster read(int row0, int col0, int rows, int cols) const override;
  std::vector<Grid> tiles() const override;

 private:
  struct Tile {
    std::string path;
    Grid grid;
    int row0 = 0, col0 = 0;  ///< of its first cell in the mosaic
    mutable std::shared_ptr<const RasterFile> file;
    mutable size_t used = 0;  ///< when, in reads
  };

  std::shared_ptr<const RasterFile> open(const Tile& tile) const;

  RasterFileOptions options_;
  std::string name_;
  Grid grid_;
  Crs crs_;
  std::vector<Tile> tiles_;
  mutable std::mutex mutex_;
  mutable size_t num_reads_ = 0;
};

}  // namespace gable
