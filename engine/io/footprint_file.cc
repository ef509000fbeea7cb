#include <gable/engine/error.h>
#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/io/readable.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>
#include <optional>
#include <unordered_set>
#include <utility>

namespace gable {
namespace {

/// Polygons smaller than this are no buildings but traces of a repair or of digitising, m2.
constexpr double kMinArea = 0.01;

constexpr const char* kIdFields[] = {"identificatie", "lokaalid", "gml_id", "building_id", "id",
                                     "osm_id",        "uuid",     "toid",   "fid"};

std::vector<Eigen::Vector2d> points_of(const OGRLinearRing& ring) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < ring.getNumPoints(); ++i) {
    const Eigen::Vector2d p(ring.getX(i), ring.getY(i));
    if (points.empty() || points.back() != p) points.push_back(p);
  }
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

PlanPolygon plan_polygon(const OGRPolygon& polygon) {
  PlanPolygon plan;
  plan.outer = points_of(*polygon.getExteriorRing());
  for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
    std::vector<Eigen::Vector2d> hole = points_of(*polygon.getInteriorRing(i));
    if (hole.size() >= 3) plan.holes.push_back(std::move(hole));
  }
  return plan;
}

/// All polygons inside a geometry of any nesting.
void collect_polygons(const OGRGeometry& geometry, std::vector<const OGRPolygon*>* polygons) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    if (!geometry.IsEmpty()) polygons->push_back(geometry.toPolygon());
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      collect_polygons(*part, polygons);
    }
  }
}

class FootprintReader {
 public:
  FootprintReader(const std::string& path, const Crs& crs, const Grid& grid) : path_(path) {
    target_ = ogr_from_crs(crs);
    target_.StripVertical();
    extent_.MinX = grid.north_west.x();
    extent_.MaxX = grid.north_west.x() + grid.cols * grid.gsd;
    extent_.MinY = grid.north_west.y() - grid.rows * grid.gsd;
    extent_.MaxY = grid.north_west.y();
  }

  FootprintFile read() {
    require_readable(path_);
    const GdalMessages messages;
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(path_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
    if (!dataset) {
      throw Error(ExitCode::kBadInput,
                  path_ + ": is not a vector file; give a GeoPackage, shapefile or GeoJSON" +
                      messages.suffix());
    }
    for (OGRLayer* layer : dataset->GetLayers()) read_layer(*layer);
    if (num_polygons_ == 0) {
      throw Error(ExitCode::kBadInput, path_ + ": holds no polygons; give building footprints");
    }
    if (file_.footprints.empty()) {
      const bool all_bad = file_.num_outside == 0;
      throw Error(ExitCode::kBadInput,
                  path_ + (all_bad ? ": none of its polygons can be used (" + file_.skipped[0] + ")"
                                   : ": none of its polygons lies on the raster; check the area "
                                     "and the reference system"));
    }
    return std::move(file_);
  }

 private:
  void read_layer(OGRLayer& layer) {
    const OGRwkbGeometryType type = wkbFlatten(layer.GetGeomType());
    if (type == wkbNone) return;
    std::unique_ptr<OGRCoordinateTransformation> transformation;
    const OGRSpatialReference* source = layer.GetSpatialRef();
    if (source && !source->IsEmpty()) {
      OGRSpatialReference flat(*source);
      flat.StripVertical();
      const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
      if (!flat.IsSame(&target_, options)) {
        transformation.reset(OGRCreateCoordinateTransformation(&flat, &target_));
        if (!transformation) {
          throw Error(ExitCode::kBadInput, path_ +
                                               ": cannot be brought into the raster's reference "
                                               "system; convert it first: ogr2ogr -t_srs EPSG:NNNN "
                                               "converted.gpkg " +
                                               path_);
        }
      }
    }
    int id_field = -1;
    for (const char* name : kIdFields) {
      if (id_field < 0) id_field = layer.GetLayerDefn()->GetFieldIndex(name);
    }
    for (const OGRFeatureUniquePtr& feature : layer) {
      read_feature(*feature, id_field, transformation.get());
    }
  }

  void read_feature(OGRFeature& feature, int id_field,
                    OGRCoordinateTransformation* transformation) {
    std::string id;
    if (id_field >= 0 && feature.IsFieldSetAndNotNull(id_field)) {
      id = feature.GetFieldAsString(id_field);
    }
    if (id.empty()) id = std::to_string(feature.GetFID());
    const OGRGeometry* stored = feature.GetGeometryRef();
    if (!stored || stored->IsEmpty()) {
      file_.skipped.push_back(id + ": has no geometry");
      return;
    }
    // Arcs become chords.
    const std::unique_ptr<OGRGeometry> linear(stored->getLinearGeometry());
    std::vector<const OGRPolygon*> polygons;
    if (linear) collect_polygons(*linear, &polygons);
    if (polygons.empty()) file_.skipped.push_back(id + ": is no polygon");
    for (const OGRPolygon* polygon : polygons) read_polygon(*polygon, id, transformation);
  }

  void read_polygon(const OGRPolygon& stored, const std::string& id,
                    OGRCoordinateTransformation* transformation) {
    ++num_polygons_;
    const std::unique_ptr<OGRPolygon> polygon(stored.clone());
    polygon->flattenTo2D();
    if (transformation && polygon->transform(transformation) != OGRERR_NONE) {
      file_.skipped.push_back(id + ": cannot be brought into the raster's reference system");
      return;
    }
    OGREnvelope envelope;
    polygon->getEnvelope(&envelope);
    const double size = (envelope.MaxX - envelope.MinX) + (envelope.MaxY - envelope.MinY);
    if (!std::isfinite(size)) {
      file_.skipped.push_back(id + ": has coordinates that are no numbers");
      return;
    }
    const std::optional<PlanPolygon> plan = repaired(*polygon, id);
    if (!plan) return;
    if (!extent_.Intersects(envelope)) {
      ++file_.num_outside;
      return;
    }
    file_.footprints.push_back({unique(id), *plan});
  }

  /// The polygon itself where it is valid, else the largest polygon of its repair.
  std::optional<PlanPolygon> repaired(const OGRPolygon& polygon, const std::string& id) {
    const GdalMessages messages;  // GEOS tells what is wrong, and where
    std::unique_ptr<OGRGeometry> made_valid;
    std::vector<const OGRPolygon*> candidates = {&polygon};
    const bool valid = polygon.IsValid();
    if (!valid) {
      made_valid.reset(polygon.MakeValid());
      candidates.clear();
      if (made_valid) collect_polygons(*made_valid, &candidates);
    }
    const OGRPolygon* largest = nullptr;
    for (const OGRPolygon* candidate : candidates) {
      if (!largest || candidate->get_Area() > largest->get_Area()) largest = candidate;
    }
    if (!largest || largest->get_Area() < kMinArea) {
      file_.skipped.push_back(id + ": encloses no area");
      return std::nullopt;
    }
    if (!valid) {
      file_.repaired.push_back(id + ": was not valid" + messages.suffix());
    }
    return plan_polygon(*largest);
  }

  std::string unique(const std::string& id) {
    std::string candidate = id;
    for (int i = 2; !ids_.insert(candidate).second; ++i) candidate = id + "-" + std::to_string(i);
    return candidate;
  }

  std::string path_;
  OGRSpatialReference target_;
  OGREnvelope extent_;
  FootprintFile file_;
  std::unordered_set<std::string> ids_;
  int num_polygons_ = 0;
};

}  // namespace

FootprintFile read_footprints(const std::string& path, const Crs& crs, const Grid& grid) {
  const GdalMessages messages;
  return FootprintReader(path, crs, grid).read();
}

}  // namespace gable
