#include <cpl_conv.h>
#include <gable/engine/error.h>
#include <gable/engine/io/footprint_writer.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/memory_file.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/ogr_polygon.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

namespace gable {
namespace {

/// Whether all features could be written.
bool write_layer(GDALDataset* dataset, const std::vector<Footprint>& footprints, const Crs& crs) {
  OGRSpatialReference srs = ogr_from_crs(crs);
  OGRLayer* layer =
      dataset->CreateLayer("footprints", crs.empty() ? nullptr : &srs, wkbPolygon, nullptr);
  if (!layer) return false;
  OGRFieldDefn id("id", OFTString);
  if (layer->CreateField(&id) != OGRERR_NONE) return false;
  if (layer->StartTransaction() != OGRERR_NONE) return false;
  for (const Footprint& footprint : footprints) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("id", footprint.id.c_str());
    const OGRPolygon polygon = ogr_polygon(footprint.polygon);
    feature.SetGeometry(&polygon);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return layer->CommitTransaction() == OGRERR_NONE;
}

}  // namespace

void write_footprints(const std::string& path, const std::vector<Footprint>& footprints,
                      const Crs& crs) {
  const GdalMessages messages;
  // A GeoPackage carries the time of its last change, which would differ from run to run.
  const CPLConfigOptionSetter fixed_date("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z", true);
  MemoryFile file(".gpkg");
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
      file.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  if (!dataset || !write_layer(dataset, footprints, crs)) {
    if (dataset) GDALClose(dataset);
    throw Error(ExitCode::kInternal, path + ": could not be composed" + messages.suffix());
  }
  file.close_and_write(dataset, path);
}

}  // namespace gable
