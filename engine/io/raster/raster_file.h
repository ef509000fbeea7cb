#pragma once

#include <gable/engine/io/raster/height_source.h>

#include <memory>
#include <string>

namespace gable {

struct RasterFileOptions {
  /// CRS of files that carry none, e.g. "EPSG:27700". Empty: such files are refused.
  std::string crs;
  /// Whether a file that holds nothing but nodata is taken as well.
  bool may_be_empty = false;
};

/// A raster of heights on disk (GeoTIFF, COG, ASC, VRT and whatever else GDAL reads), read window
/// by window. Once open it is known to lie on a north-up grid of square cells in projected metres
/// and to hold at least one height. Reading is safe from several threads (one at a time).
class RasterFile : public HeightSource {
 public:
  /// Throws Error, naming the file and the remedy: kNoInput where it does not exist or may not be
  /// read; kBadInput where it is no raster, has several bands, no georeference, a turned or
  /// non-square grid, no CRS, a CRS that is not in projected metres, fewer than 2 x 2 cells, or
  /// nothing but nodata. Throws kUsage where options.crs is no CRS.
  explicit RasterFile(const std::string& path, const RasterFileOptions& options = {});
  ~RasterFile() override;
  RasterFile(RasterFile&&) noexcept;
  RasterFile& operator=(RasterFile&&) noexcept;

  const std::string& path() const override;
  const Grid& grid() const override;
  const Crs& crs() const override;

  /// The cells [row0, row0 + rows) x [col0, col0 + cols), which must lie inside grid(). Metres;
  /// heights in feet are converted where the file declares them. NaN for nodata, infinite values
  /// and values no terrain has (beyond 10 km). Throws Error (kBadInput) where the file is damaged.
  HeightRaster read(int row0, int col0, int rows, int cols) const override;
  HeightRaster read() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gable
