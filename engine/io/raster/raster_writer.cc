#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/memory_file.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gdal_priv.h>

#include <array>
#include <cmath>

namespace gable {
namespace {

constexpr float kNodata = -9999.0f;

}  // namespace

void write_raster(const std::string& path, const HeightRaster& heights, const Crs& crs) {
  const GdalMessages messages;
  MemoryFile file(".tif");
  const Grid& grid = heights.grid;
  const char* options[] = {"TILED=YES", "COMPRESS=DEFLATE", "PREDICTOR=3", nullptr};
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file.name().c_str(), grid.cols, grid.rows, 1, GDT_Float32, const_cast<char**>(options));
  if (!dataset) {
    throw Error(ExitCode::kInternal, path + ": could not be composed" + messages.suffix());
  }
  std::array<double, 6> gt = {grid.north_west.x(), grid.gsd, 0.0,
                              grid.north_west.y(), 0.0,      -grid.gsd};
  dataset->SetGeoTransform(gt.data());
  const OGRSpatialReference srs = ogr_from_crs(crs);
  if (!crs.empty()) dataset->SetSpatialRef(&srs);
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(kNodata);
  std::vector<float> row(grid.cols);
  for (int r = 0; r < grid.rows; ++r) {
    for (int c = 0; c < grid.cols; ++c) {
      row[c] = std::isfinite(heights.at(r, c)) ? heights.at(r, c) : kNodata;
    }
    if (band->RasterIO(GF_Write, 0, r, grid.cols, 1, row.data(), grid.cols, 1, GDT_Float32, 0, 0,
                       nullptr) != CE_None) {
      break;  // close_and_write sees the message
    }
  }
  if (messages.failed()) {
    GDALClose(dataset);
    throw Error(ExitCode::kInternal, path + ": could not be composed" + messages.suffix());
  }
  file.close_and_write(dataset, path);
}

}  // namespace gable
