#include <gable/engine/error.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/raster/raster_mosaic.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr size_t kMostOpen = 64;
/// Largest distance, in cells, between the cells of a file and those of the common grid.
constexpr double kTolerance = 0.05;
constexpr double kMostCells = 1e9;  // in one direction

std::string text_of(double value) {
  std::string text;
  append_number(value, &text);
  return text;
}

[[noreturn]] void refuse(const std::string& path, const std::string& problem,
                         const std::string& remedy) {
  throw Error(ExitCode::kBadInput, path + ": " + problem + "; warp it first: gdalwarp " + remedy +
                                       " -r bilinear " + path + " warped.tif");
}

void require_alike(const RasterFile& file, const RasterFile& first) {
  const Grid &grid = file.grid(), &common = first.grid();
  if (!same_horizontal_crs(file.crs(), first.crs())) {
    refuse(file.path(),
           "is in " + file.crs().name + ", but " + first.path() + " is in " + first.crs().name,
           "-t_srs " + (first.crs().epsg ? "EPSG:" + std::to_string(first.crs().epsg)
                                         : std::string("EPSG:NNNN")));
  }
  const std::string size = text_of(common.gsd);
  if (std::abs(grid.gsd - common.gsd) * std::max(grid.rows, grid.cols) > kTolerance * common.gsd) {
    refuse(file.path(),
           "has cells of " + text_of(grid.gsd) + " m, but " + first.path() + " of " + size + " m",
           "-tap -tr " + size + " " + size);
  }
  const Eigen::Vector2d offset = (grid.north_west - common.north_west) / common.gsd;
  if ((offset.array() - offset.array().round()).abs().maxCoeff() > kTolerance) {
    refuse(file.path(), "its cells lie between those of " + first.path(),
           "-tap -tr " + size + " " + size);
  }
}

}  // namespace

RasterMosaic::RasterMosaic(const std::vector<std::string>& paths, const RasterFileOptions& options)
    : options_(options) {
  CHECK(!paths.empty());
  options_.may_be_empty = true;
  const RasterFile first(paths.front(), options_);
  crs_ = first.crs();
  const double gsd = first.grid().gsd;
  for (const std::string& path : paths) {
    const RasterFile file(path, options_);
    require_alike(file, first);
    Tile tile;
    tile.path = path;
    tile.grid = file.grid();
    const Eigen::Vector2d offset = (tile.grid.north_west - first.grid().north_west) / gsd;
    if (offset.cwiseAbs().maxCoeff() > kMostCells) {
      throw Error(ExitCode::kBadInput,
                  path + ": lies too far from " + paths.front() + "; give tiles of one area");
    }
    tile.row0 = static_cast<int>(std::lround(-offset.y()));
    tile.col0 = static_cast<int>(std::lround(offset.x()));
    tile.grid.gsd = gsd;
    tile.grid.north_west = first.grid().north_west + gsd * Eigen::Vector2d(tile.col0, -tile.row0);
    tiles_.push_back(std::move(tile));
  }
  int row0 = 0, col0 = 0;  // those of the first file
  for (const Tile& tile : tiles_) {
    row0 = std::min(row0, tile.row0);
    col0 = std::min(col0, tile.col0);
  }
  grid_.gsd = gsd;
  grid_.north_west = first.grid().north_west + gsd * Eigen::Vector2d(col0, -row0);
  for (Tile& tile : tiles_) {
    tile.row0 -= row0;
    tile.col0 -= col0;
    grid_.rows = std::max(grid_.rows, tile.row0 + tile.grid.rows);
    grid_.cols = std::max(grid_.cols, tile.col0 + tile.grid.cols);
  }
  name_ = paths.front();
  if (paths.size() > 1) name_ += " and " + std::to_string(paths.size() - 1) + " more";
  constexpr int kStrip = 256;
  if (std::none_of(tiles_.begin(), tiles_.end(),
                   [&](const Tile& tile) { return holds_height(*open(tile), kStrip); })) {
    throw Error(ExitCode::kBadInput,
                name_ + ": hold no height at all, every cell is nodata; check their nodata value");
  }
}

std::shared_ptr<const RasterFile> RasterMosaic::open(const Tile& tile) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  tile.used = ++num_reads_;
  if (tile.file) return tile.file;
  const Tile* oldest = nullptr;
  size_t num_open = 0;
  for (const Tile& other : tiles_) {
    if (!other.file) continue;
    ++num_open;
    if (!oldest || other.used < oldest->used) oldest = &other;
  }
  if (num_open >= kMostOpen) oldest->file.reset();
  tile.file = std::make_shared<RasterFile>(tile.path, options_);
  return tile.file;
}

HeightRaster RasterMosaic::read(int row0, int col0, int rows, int cols) const {
  HeightRaster out(
      {grid_.north_west + grid_.gsd * Eigen::Vector2d(col0, -row0), grid_.gsd, rows, cols},
      std::numeric_limits<float>::quiet_NaN());
  for (const Tile& tile : tiles_) {
    const int top = std::max(row0, tile.row0), left = std::max(col0, tile.col0);
    const int bottom = std::min(row0 + rows, tile.row0 + tile.grid.rows);
    const int right = std::min(col0 + cols, tile.col0 + tile.grid.cols);
    if (top >= bottom || left >= right) continue;
    const HeightRaster part =
        open(tile)->read(top - tile.row0, left - tile.col0, bottom - top, right - left);
    for (int row = top; row < bottom; ++row) {
      for (int col = left; col < right; ++col) {
        float& z = out.at(row - row0, col - col0);
        if (std::isnan(z)) z = part.at(row - top, col - left);
      }
    }
  }
  return out;
}

std::vector<Grid> RasterMosaic::tiles() const {
  std::vector<Grid> grids;
  for (const Tile& tile : tiles_) grids.push_back(tile.grid);
  return grids;
}

}  // namespace gable
