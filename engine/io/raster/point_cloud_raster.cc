#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/io/raster/fill_gaps.h>
#include <gable/engine/io/raster/point_cloud_raster.h>
#include <gable/engine/io/scans/las_points.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <utility>

namespace gable {
namespace {

constexpr float kNoHeight = std::numeric_limits<float>::quiet_NaN();
/// Cells that are gathered in one pass over a file.
constexpr int64_t kMostCells = int64_t{1} << 23;
constexpr int kMostStripRows = 512;
constexpr double kMostCellsAcross = 1e9;
constexpr double kMaxHeight = 10000.0;  // no terrain lies beyond, as in raster files
constexpr double kUnitTolerance = 1e-6;

constexpr int kGround = 2, kBuilding = 6, kNoise = 7, kKeyPoint = 8, kWater = 9, kHighNoise = 18;

bool is_ground(int classification) {
  return classification == kGround || classification == kKeyPoint;
}

bool may_be_used(const LasPoint& point) {
  return !point.withheld && point.classification != kNoise && point.classification != kHighNoise;
}

bool is_surface(const LasPoint& point, bool with_buildings) {
  if (!may_be_used(point)) return false;
  const int c = point.classification;
  return !with_buildings || is_ground(c) || c == kBuilding || c == kWater;
}

[[noreturn]] void refuse(const std::string& path, const std::string& line) {
  throw Error(ExitCode::kBadInput, path + ": " + line);
}

/// What a file holds.
struct Survey {
  std::string path;
  Crs crs;
  double metres_per_height_unit = 1.0;
  Eigen::AlignedBox2d extent;  ///< of the points that may be used
  bool ground = false, buildings = false;
  size_t num_points = 0;
};

/// Reads and checks the reference system: projected, in metres.
void survey_crs(const std::string& fallback, Survey* survey) {
  const std::string& path = survey->path;
  survey->crs = read_las_crs(path);
  if (survey->crs.empty() && !fallback.empty()) survey->crs = crs_from_text(fallback);
  if (survey->crs.empty()) {
    refuse(path, "has no coordinate reference system; name it with --crs EPSG:NNNN");
  }
  const GdalMessages messages;
  OGRSpatialReference srs = ogr_from_crs(survey->crs);
  if (!srs.IsProjected() || std::abs(srs.GetLinearUnits() - 1.0) > kUnitTolerance) {
    refuse(path, "is not in projected metres (" + survey->crs.name +
                     "); reproject it first, to your country's grid in metres");
  }
  if (!srs.IsCompound()) return;
  survey->metres_per_height_unit = srs.GetTargetLinearUnits("VERT_CS", nullptr);
  if (std::abs(survey->metres_per_height_unit - 1.0) < kUnitTolerance) {
    survey->metres_per_height_unit = 1.0;
  } else {
    srs.StripVertical();  // the heights become metres, so it no longer holds
    survey->crs = crs_from_ogr(srs);
  }
}

Survey survey_file(const std::string& path, const PointCloudRasterOptions& options) {
  Survey survey;
  survey.path = path;
  survey_crs(options.crs, &survey);
  visit_las_points(path, [&](const LasPoint& point) {
    ++survey.num_points;
    if (!may_be_used(point)) return;
    survey.extent.extend(point.position.head<2>());
    survey.ground |= is_ground(point.classification);
    survey.buildings |= point.classification == kBuilding;
  });
  if (survey.extent.isEmpty()) {
    refuse(path, "holds no point but noise; check the classification");
  }
  return survey;
}

/// The smallest grid with cells at whole multiples of `gsd` that holds an extent.
Grid grid_of(const Eigen::AlignedBox2d& extent, double gsd, const std::string& path) {
  const Eigen::Array2d low = (extent.min().array() / gsd).floor();
  const Eigen::Array2d high = (extent.max().array() / gsd).floor() + 1.0;
  if ((high - low).maxCoeff() > kMostCellsAcross || !(high - low).allFinite()) {
    refuse(path,
           "its points lie too far apart, or too far from those of the others; check its "
           "scale and offset");
  }
  const Eigen::Array2d size = (high - low).max(2.0);
  return {{gsd * low.x(), gsd * (low.y() + size.y())},
          gsd,
          static_cast<int>(size.y()),
          static_cast<int>(size.x())};
}

/// Adds the points of a file to the rasters. Returns how many are of the surface.
size_t add_points(const Survey& survey, bool with_buildings, PointCloudRaster* raster) {
  const Grid& whole = raster->dsm->grid();
  const Grid part = grid_of(survey.extent, whole.gsd, survey.path);
  // In whole cells from the origin of the CRS: a point on the line between two cells is counted as
  // `grid_of` counts it.
  const auto north = static_cast<int64_t>(std::llround(whole.north_west.y() / whole.gsd));
  const auto west = static_cast<int64_t>(std::llround(whole.north_west.x() / whole.gsd));
  const auto row0 = static_cast<int>(north - std::llround(part.north_west.y() / whole.gsd));
  const auto col0 = static_cast<int>(std::llround(part.north_west.x() / whole.gsd) - west);
  const int rows = std::min(part.rows, whole.rows - row0);
  const int cols = std::min(part.cols, whole.cols - col0);
  const int band_rows = static_cast<int>(std::max<int64_t>(1, kMostCells / cols));
  size_t num_used = 0;
  for (int band = 0; band < rows; band += band_rows) {
    const int height = std::min(band_rows, rows - band);
    // Another file may have points in the cells along its edge.
    HeightRaster dsm = raster->dsm->read(row0 + band, col0, height, cols), dtm;
    if (raster->dtm) dtm = raster->dtm->read(row0 + band, col0, height, cols);
    visit_las_points(survey.path, [&](const LasPoint& point) {
      if (!may_be_used(point)) return;
      const Eigen::Array2d cell = (point.position.head<2>().array() / whole.gsd).floor();
      const auto row = static_cast<int>(north - 1 - static_cast<int64_t>(cell.y())) - row0 - band;
      const auto col = static_cast<int>(static_cast<int64_t>(cell.x()) - west) - col0;
      if (!dsm.grid.contains(row, col)) return;
      const double z = survey.metres_per_height_unit * point.position.z();
      if (std::abs(z) > kMaxHeight) return;
      const auto height_here = static_cast<float>(z);
      if (is_surface(point, with_buildings)) {
        ++num_used;
        float& top = dsm.at(row, col);
        if (!(top >= height_here)) top = height_here;
      }
      if (raster->dtm && is_ground(point.classification)) {
        float& ground = dtm.at(row, col);
        if (!(ground <= height_here)) ground = height_here;
      }
    });
    raster->dsm->write(dsm, row0 + band, col0);
    if (raster->dtm) raster->dtm->write(dtm, row0 + band, col0);
  }
  return num_used;
}

/// Strip by strip; the rows above a strip are those from before they were filled.
void fill_gaps(int reach, ScratchHeights* heights) {
  const Grid& grid = heights->grid();
  const int strip_rows =
      static_cast<int>(std::clamp<int64_t>(kMostCells / grid.cols, reach, kMostStripRows));
  HeightRaster above({grid.north_west, grid.gsd, 0, grid.cols}, kNoHeight);
  for (int row = 0; row < grid.rows; row += strip_rows) {
    const int rows = std::min(strip_rows, grid.rows - row);
    const int below = std::min(reach, grid.rows - row - rows);
    const HeightRaster strip = heights->read(row, 0, rows + below, grid.cols);
    HeightRaster padded({grid.north_west, grid.gsd, above.grid.rows + rows + below, grid.cols},
                        kNoHeight);
    std::copy(above.values.begin(), above.values.end(), padded.values.begin());
    std::copy(strip.values.begin(), strip.values.end(),
              padded.values.begin() + static_cast<std::ptrdiff_t>(above.values.size()));
    const HeightRaster filled = fill_narrow_gaps(padded, reach);
    HeightRaster inner({grid.north_west, grid.gsd, rows, grid.cols}, kNoHeight);
    std::copy_n(filled.values.begin() + static_cast<std::ptrdiff_t>(above.values.size()),
                inner.values.size(), inner.values.begin());
    const int kept = std::min(reach, rows);
    above = HeightRaster({grid.north_west, grid.gsd, kept, grid.cols}, kNoHeight);
    std::copy_n(strip.values.begin() + static_cast<std::ptrdiff_t>(rows - kept) * grid.cols,
                above.values.size(), above.values.begin());
    heights->write(inner, row, 0);
  }
}

std::string percent(size_t part, size_t whole) {
  return std::to_string(std::lround(100.0 * static_cast<double>(part) /
                                    static_cast<double>(std::max<size_t>(1, whole)))) +
         " %";
}

}  // namespace

std::string check(const PointCloudRasterOptions& options) {
  if (!(options.gsd >= 0.05 && options.gsd <= 10.0)) return "gsd must lie in [0.05, 10] m";
  if (!(options.gap >= 0.0 && options.gap <= 10.0)) return "gap must lie in [0, 10] m";
  return "";
}

PointCloudRaster rasterise_point_clouds(const std::vector<std::string>& paths,
                                        const PointCloudRasterOptions& options) {
  CHECK(!paths.empty());
  CHECK(check(options).empty()) << check(options);
  std::vector<Survey> surveys;
  Eigen::AlignedBox2d extent;
  bool with_buildings = false, with_ground = true;
  PointCloudRaster raster;
  for (const std::string& path : paths) {
    surveys.push_back(survey_file(path, options));
    const Survey &survey = surveys.back(), &first = surveys.front();
    if (!same_horizontal_crs(survey.crs, first.crs)) {
      refuse(path, "is in " + survey.crs.name + ", but " + first.path + " is in " + first.crs.name +
                       "; reproject it first");
    }
    extent.extend(survey.extent);
    grid_of(extent, options.gsd, path);
    with_buildings |= survey.buildings;
    with_ground &= survey.ground;
    raster.num_points += survey.num_points;
  }
  std::string name = paths.front();
  if (paths.size() > 1) name += " and " + std::to_string(paths.size() - 1) + " more";
  const Grid grid = grid_of(extent, options.gsd, name);
  const Crs& crs = surveys.front().crs;
  raster.dsm = std::make_unique<ScratchHeights>(grid, crs, name, options.scratch);
  if (with_ground) {
    raster.dtm = std::make_unique<ScratchHeights>(grid, crs, name, options.scratch);
  }
  std::vector<Grid> tiles;
  for (const Survey& survey : surveys) {
    raster.num_used += add_points(survey, with_buildings, &raster);
    tiles.push_back(grid_of(survey.extent, options.gsd, survey.path));
  }
  if (raster.num_used == 0) refuse(name, "holds no usable height; check the classification");
  fill_gaps(std::max(2, static_cast<int>(std::lround(options.gap / options.gsd))),
            raster.dsm.get());
  raster.dsm->set_tiles(tiles);
  if (raster.dtm) raster.dtm->set_tiles(tiles);
  raster.used = "the surface is made of " + percent(raster.num_used, raster.num_points) + " of " +
                std::to_string(raster.num_points) + " points" +
                (with_buildings ? " (classes 2, 6, 8 and 9)" : " (all classes but noise)") +
                (with_ground ? ", the terrain of class 2" : ", none are ground (class 2)");
  return raster;
}

bool is_point_cloud(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".las" || extension == ".laz";
}

}  // namespace gable
