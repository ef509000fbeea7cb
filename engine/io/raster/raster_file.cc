#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/raster/raster_crs.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/readable.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace gable {
namespace {

constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();
/// No terrain or building on Earth lies beyond; such values are forgotten nodata markers.
constexpr double kMaxHeight = 10000.0;

}  // namespace

struct RasterFile::Impl {
  std::string path;
  GDALDatasetUniquePtr dataset;
  GDALRasterBand* band = nullptr;
  bool masked = false;
  double scale = 1.0;  ///< metres = scale * value + offset
  double offset = 0.0;
  Grid grid;
  Crs crs;
  std::mutex mutex;

  void open(const RasterFileOptions& options);
  HeightRaster read(int row0, int col0, int rows, int cols);
  void require(CPLErr status, const GdalMessages& messages) const;
};

void RasterFile::Impl::open(const RasterFileOptions& options) {
  const GdalMessages messages;
  require_readable(path);
  dataset.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset || dataset->GetRasterCount() == 0) {
    throw Error(
        ExitCode::kBadInput,
        path + ": is not a raster; give a GeoTIFF, COG, ASC or VRT of heights" + messages.suffix());
  }
  band = dataset->GetRasterBand(1);
  const int bands = dataset->GetRasterCount();
  const bool second_is_alpha =
      bands == 2 && dataset->GetRasterBand(2)->GetColorInterpretation() == GCI_AlphaBand;
  if (bands > 1 && !second_is_alpha) {
    throw Error(ExitCode::kBadInput, path + ": has " + std::to_string(bands) +
                                         " bands, heights are one; pick it: gdal_translate -b 1 " +
                                         path + " heights.tif");
  }
  grid = raster_grid(*dataset, path);
  RasterCrs checked = raster_crs(*dataset, path, options.crs);
  crs = std::move(checked.crs);
  masked = !(band->GetMaskFlags() & GMF_ALL_VALID);
  scale = band->GetScale() * checked.metres_per_height_unit;
  offset = band->GetOffset() * checked.metres_per_height_unit;
}

void RasterFile::Impl::require(CPLErr status, const GdalMessages& messages) const {
  if (status == CE_None) return;
  throw Error(ExitCode::kBadInput,
              path + ": is damaged, its cells cannot be read" + messages.suffix());
}

HeightRaster RasterFile::Impl::read(int row0, int col0, int rows, int cols) {
  assert(row0 >= 0 && col0 >= 0 && rows >= 0 && cols >= 0);
  assert(row0 + rows <= grid.rows && col0 + cols <= grid.cols);
  HeightRaster out(
      {grid.north_west + grid.gsd * Eigen::Vector2d(col0, -row0), grid.gsd, rows, cols}, kNoHeight);
  if (out.values.empty()) return out;
  std::vector<GByte> mask;
  {
    const GdalMessages messages;
    const std::lock_guard<std::mutex> lock(mutex);
    require(band->RasterIO(GF_Read, col0, row0, cols, rows, out.values.data(), cols, rows,
                           GDT_Float32, 0, 0, nullptr),
            messages);
    if (masked) {
      mask.resize(out.values.size());
      require(band->GetMaskBand()->RasterIO(GF_Read, col0, row0, cols, rows, mask.data(), cols,
                                            rows, GDT_Byte, 0, 0, nullptr),
              messages);
    }
  }
  for (size_t i = 0; i < out.values.size(); ++i) {
    const double z = scale * out.values[i] + offset;
    const bool valid = (mask.empty() || mask[i] != 0) && std::abs(z) <= kMaxHeight;
    out.values[i] = valid ? static_cast<float>(z) : kNoHeight;
  }
  return out;
}

RasterFile::RasterFile(const std::string& path, const RasterFileOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->open(options);
  // By strips of the file's own blocks: nothing but the first one, unless it starts with nodata.
  int block_cols = 0, block_rows = 0;
  impl_->band->GetBlockSize(&block_cols, &block_rows);
  if (!options.may_be_empty && !holds_height(*this, std::clamp(block_rows, 1, 512))) {
    throw Error(ExitCode::kBadInput,
                path + ": holds no height at all, every cell is nodata; check its nodata value");
  }
}

RasterFile::~RasterFile() = default;
RasterFile::RasterFile(RasterFile&&) noexcept = default;
RasterFile& RasterFile::operator=(RasterFile&&) noexcept = default;

const std::string& RasterFile::path() const { return impl_->path; }
const Grid& RasterFile::grid() const { return impl_->grid; }
const Crs& RasterFile::crs() const { return impl_->crs; }

HeightRaster RasterFile::read(int row0, int col0, int rows, int cols) const {
  return impl_->read(row0, col0, rows, cols);
}

HeightRaster RasterFile::read() const { return read(0, 0, grid().rows, grid().cols); }

}  // namespace gable
