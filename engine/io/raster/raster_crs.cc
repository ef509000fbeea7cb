#include <gable/engine/error.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/io/raster/raster_crs.h>
#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <memory>
#include <string_view>

namespace gable {
namespace {

/// Largest drift, in cells, that a slightly turned or non-square grid may show across the raster.
constexpr double kGridTolerance = 0.05;
constexpr double kUnitTolerance = 1e-6;
constexpr double kFoot = 0.3048;
constexpr double kUsSurveyFoot = 1200.0 / 3937.0;

[[noreturn]] void refuse(const std::string& line) { throw Error(ExitCode::kBadInput, line); }

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// "EPSG:32631": the UTM zone of the raster's centre, as a projected CRS in metres that fits.
std::string utm_zone_at_center(GDALDataset& dataset, const OGRSpatialReference& srs) {
  std::array<double, 6> gt{};
  if (dataset.GetGeoTransform(gt.data()) != CE_None) return "EPSG:NNNN";
  double x = gt[0] + 0.5 * (gt[1] * dataset.GetRasterXSize() + gt[2] * dataset.GetRasterYSize());
  double y = gt[3] + 0.5 * (gt[4] * dataset.GetRasterXSize() + gt[5] * dataset.GetRasterYSize());
  OGRSpatialReference from(srs), to;
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetWellKnownGeogCS("WGS84");
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&from, &to));
  if (!transformation || !transformation->Transform(1, &x, &y)) return "EPSG:NNNN";
  if (!(std::abs(x) <= 180.0 && std::abs(y) <= 84.0)) return "EPSG:NNNN";
  const int zone = std::min(60, static_cast<int>(std::floor((x + 180.0) / 6.0)) + 1);
  return "EPSG:" + std::to_string((y < 0.0 ? 32700 : 32600) + zone);
}

std::string warp_remedy(GDALDataset& dataset, const OGRSpatialReference& srs,
                        const std::string& path) {
  return "; warp it first: gdalwarp -t_srs " + utm_zone_at_center(dataset, srs) + " -r bilinear " +
         path + " warped.tif (or to your country's grid in metres)";
}

/// Metres per unit of a band's own unit text; 1 where there is none or it is not known.
double metres_per_unit(std::string_view unit) {
  if (unit == "ft" || unit == "foot" || unit == "feet") return kFoot;
  if (unit == "US survey foot" || unit == "us-ft" || unit == "ftUS" || unit == "sft") {
    return kUsSurveyFoot;
  }
  return 1.0;
}

}  // namespace

RasterCrs raster_crs(GDALDataset& dataset, const std::string& path, const std::string& fallback) {
  const OGRSpatialReference* stored = dataset.GetSpatialRef();
  OGRSpatialReference srs;
  if (stored && !stored->IsEmpty() && !stored->IsLocal()) {
    srs = *stored;
  } else if (!fallback.empty()) {
    srs = ogr_from_crs(crs_from_text(fallback));
  } else {
    refuse(path +
           ": has no coordinate reference system; name it with --crs EPSG:NNNN, or write it into "
           "the file: gdal_edit.py -a_srs EPSG:NNNN " +
           path);
  }
  if (srs.IsGeographic()) {
    refuse(path + ": is in degrees (" + srs.GetName() + "), not in projected metres" +
           warp_remedy(dataset, srs, path));
  }
  if (!srs.IsProjected()) {
    refuse(path + ": is not in a projected coordinate reference system (" + srs.GetName() + ")" +
           warp_remedy(dataset, srs, path));
  }
  const char* unit = nullptr;
  if (std::abs(srs.GetLinearUnits(&unit) - 1.0) > kUnitTolerance) {
    refuse(path + ": is in " + (unit ? unit : "unknown units") + ", not in metres (" +
           srs.GetName() + ")" + warp_remedy(dataset, srs, path));
  }
  RasterCrs result;
  if (srs.IsCompound()) {
    result.metres_per_height_unit = srs.GetTargetLinearUnits("VERT_CS", nullptr);
  } else {
    result.metres_per_height_unit = metres_per_unit(dataset.GetRasterBand(1)->GetUnitType());
  }
  if (std::abs(result.metres_per_height_unit - 1.0) < kUnitTolerance) {
    result.metres_per_height_unit = 1.0;
  } else {
    srs.StripVertical();
  }
  result.crs = crs_from_ogr(srs);
  return result;
}

Grid raster_grid(GDALDataset& dataset, const std::string& path) {
  Grid grid;
  grid.rows = dataset.GetRasterYSize();
  grid.cols = dataset.GetRasterXSize();
  if (grid.rows < 2 || grid.cols < 2) {
    refuse(path + ": has only " + std::to_string(grid.cols) + " x " + std::to_string(grid.rows) +
           " cells; give a raster that covers at least one house");
  }
  std::array<double, 6> gt{};
  if (dataset.GetGeoTransform(gt.data()) != CE_None) {
    refuse(path +
           ": has no georeference; write one into it: gdal_edit.py -a_ullr WEST NORTH EAST "
           "SOUTH " +
           path);
  }
  const std::string warp = "; warp it first: gdalwarp -r bilinear ";
  const double cells = std::max(grid.rows, grid.cols);
  const double tolerance = kGridTolerance / cells * std::abs(gt[1]);
  if (std::abs(gt[2]) > tolerance || std::abs(gt[4]) > tolerance) {
    refuse(path + ": its grid is turned against north" + warp + path + " warped.tif");
  }
  if (!(gt[1] > 0.0) || !(gt[5] < 0.0)) {
    refuse(path + ": its rows do not run from north to south" + warp + path + " warped.tif");
  }
  if (std::abs(gt[1] + gt[5]) > tolerance) {
    const std::string size = number(std::min(gt[1], -gt[5]));
    refuse(path + ": its cells are not square (" + number(gt[1]) + " x " + number(-gt[5]) + ")" +
           warp + "-tr " + size + " " + size + " " + path + " warped.tif");
  }
  grid.north_west = {gt[0], gt[3]};
  grid.gsd = gt[1];
  return grid;
}

}  // namespace gable
