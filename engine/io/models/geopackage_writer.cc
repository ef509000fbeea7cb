#include <cpl_conv.h>
#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/memory_file.h>
#include <gable/engine/io/models/building_figures.h>
#include <gable/engine/io/models/geopackage_writer.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/grammar/solid/plane.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

/// Pieces of a roof smaller than this are what rounding left, m2.
constexpr double kLeastRoof = 0.01;
/// Roofs flatter than this face nowhere, degrees.
constexpr double kLevel = 0.5;
/// How far from a roof's plane a part's underside may lie and still rest on it, metres.
constexpr double kRestsOn = 0.03;
constexpr double kDegrees = 180.0 / M_PI;

/// Columns that are there whatever the buildings are like.
constexpr const char* kTextColumns[] = {"gable_status", "gable_reason", "gable_foundation",
                                        "gable_roofs"};
constexpr const char* kCountColumns[] = {"gable_dormers", "gable_chimneys", "gable_garages"};
constexpr const char* kNumberColumns[] = {
    "gable_azimuth_deg", "gable_eaves_m",      "gable_ridge_m",      "gable_mad_m",
    "gable_rmse_m",      "gable_plan_area_m2", "gable_roof_area_m2", "gable_volume_m3"};

/// The face in plan, world frame; its holes cut out.
OGRPolygon plan_polygon(const Solid& solid, const Face& face, const Eigen::Vector3d& origin) {
  OGRPolygon polygon;
  for (const std::vector<int>& ring : face.rings) {
    OGRLinearRing points;
    for (const int v : ring) {
      points.addPoint(origin.x() + solid.vertices[v].x(), origin.y() + solid.vertices[v].y());
    }
    points.closeRings();
    points.flattenTo2D();
    polygon.addRing(&points);
  }
  return polygon;
}

void append_polygons(const OGRGeometry& geometry, OGRMultiPolygon* polygons) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon && !geometry.IsEmpty()) {
    polygons->addGeometry(&geometry);
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      append_polygons(*part, polygons);
    }
  }
}

/// The union of polygons, or all of them side by side where they cannot be joined.
OGRMultiPolygon united(const OGRMultiPolygon& polygons) {
  OGRMultiPolygon result;
  const std::unique_ptr<OGRGeometry> joined(polygons.UnionCascaded());
  append_polygons(joined ? *joined : static_cast<const OGRGeometry&>(polygons), &result);
  return result;
}

/// The plane of a face that is not vertical, local frame.
Plane plane_of(const Solid& solid, const Face& face, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d& p = solid.vertices[face.rings[0][0]];
  const double a = -normal.x() / normal.z(), b = -normal.y() / normal.z();
  return {a, b, p.z() - a * p.x() - b * p.y()};
}

/// An underside that rests on something.
struct Cover {
  OGRPolygon plan;
  Eigen::Vector3d inside;  ///< a point of it, local frame
};

std::vector<Cover> covers_of(const BuildingModel& model) {
  std::vector<Cover> covers;
  const double bottom = bottom_of(model);
  for (const PartModel& part : model.parts) {
    const Solid* solid = finest_solid_without_slabs(part);
    if (!solid) continue;
    for (const Face& face : solid->faces) {
      if (face.type != SurfaceType::kGround || is_on_the_ground(*solid, face, bottom)) continue;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const int v : face.rings[0]) mean += solid->vertices[v];
      covers.push_back({plan_polygon(*solid, face, model.origin),
                        mean / static_cast<double>(face.rings[0].size())});
    }
  }
  return covers;
}

/// What is seen of a roof face, in space.
OGRMultiPolygon seen_roof(const Solid& solid, const Face& face, const Plane& plane,
                          const BuildingModel& model, const std::vector<Cover>& covers) {
  std::unique_ptr<OGRGeometry> left(plan_polygon(solid, face, model.origin).clone());
  for (const Cover& cover : covers) {
    if (std::abs(plane.at(cover.inside.head<2>()) - cover.inside.z()) > kRestsOn) continue;
    std::unique_ptr<OGRGeometry> rest(left->Difference(&cover.plan));
    if (rest) left = std::move(rest);
  }
  OGRMultiPolygon pieces, seen;
  append_polygons(*left, &pieces);
  for (const OGRPolygon* piece : pieces) {
    if (piece->get_Area() < kLeastRoof) continue;
    OGRPolygon raised;
    for (const OGRLinearRing* ring : *piece) {
      OGRLinearRing points;
      for (int i = 0; i < ring->getNumPoints(); ++i) {
        const Eigen::Vector2d p(ring->getX(i), ring->getY(i));
        points.addPoint(p.x(), p.y(), model.origin.z() + plane.at(p - model.origin.head<2>()));
      }
      raised.addRing(&points);
    }
    seen.addGeometry(&raised);
  }
  return seen;
}

double plan_area(const OGRMultiPolygon& polygons) {
  double area = 0.0;
  for (const OGRPolygon* polygon : polygons) area += polygon->get_Area();
  return area;
}

bool add_column(OGRLayer* layer, const std::string& name, OGRFieldType type,
                OGRFieldSubType subtype = OFSTNone) {
  OGRFieldDefn field(name.c_str(), type);
  field.SetSubType(subtype);
  return layer->CreateField(&field) == OGRERR_NONE;
}

std::string utf8(const std::string& text) {
  return Json::parse(dump_json(Json(text))).get<std::string>();
}

std::string listed(const Json& list) {
  std::string text;
  for (const Json& item : list) {
    text +=
        (text.empty() ? "" : ", ") + (item.is_string() ? item.get<std::string>() : dump_json(item));
  }
  return text;
}

void set_column(const std::string& name, const Json& value, OGRFeature* feature) {
  const int column = feature->GetFieldIndex(name.c_str());
  if (column < 0) return;
  if (value.is_number_integer()) {
    feature->SetField(column, value.get<GIntBig>());
  } else if (value.is_number()) {
    feature->SetField(column, value.get<double>());
  } else if (value.is_string()) {
    feature->SetField(column, utf8(value.get<std::string>()).c_str());
  } else {
    feature->SetField(column, utf8(value.is_array() ? listed(value) : dump_json(value)).c_str());
  }
}

}  // namespace

/// What the tables will hold.
struct GeoPackageWriter::Rows {
  struct BuildingRow {
    std::string id;
    Json attributes;
    std::string derivation;
    OGRMultiPolygon plan;
  };
  struct RoofRow {
    std::string building, part;
    double area, plan_area, slope, aspect;
    OGRMultiPolygon roof;
  };
  std::vector<BuildingRow> buildings;
  std::vector<RoofRow> roofs;

  bool write_buildings(GDALDataset* dataset, OGRSpatialReference* srs) const;
  bool write_roofs(GDALDataset* dataset, OGRSpatialReference* srs) const;
};

bool GeoPackageWriter::Rows::write_buildings(GDALDataset* dataset, OGRSpatialReference* srs) const {
  OGRLayer* layer = dataset->CreateLayer("buildings", srs, wkbMultiPolygon, nullptr);
  if (!layer || !add_column(layer, "id", OFTString)) return false;
  for (const char* name : kTextColumns) {
    if (!add_column(layer, name, OFTString)) return false;
  }
  for (const char* name : kCountColumns) {
    if (!add_column(layer, name, OFTInteger)) return false;
  }
  for (const char* name : kNumberColumns) {
    if (!add_column(layer, name, OFTReal)) return false;
  }
  for (const BuildingRow& row : buildings) {
    for (const auto& [name, value] : row.attributes.items()) {
      if (layer->GetLayerDefn()->GetFieldIndex(name.c_str()) >= 0) continue;
      const OGRFieldType type = value.is_number_integer() ? OFTInteger64
                                : value.is_number()       ? OFTReal
                                                          : OFTString;
      if (!add_column(layer, name, type)) return false;
    }
  }
  if (!add_column(layer, "gable_derivation", OFTString, OFSTJSON)) return false;
  if (layer->StartTransaction() != OGRERR_NONE) return false;
  for (const BuildingRow& row : buildings) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("id", utf8(row.id).c_str());
    for (const auto& [name, value] : row.attributes.items()) set_column(name, value, &feature);
    feature.SetField("gable_derivation", row.derivation.c_str());
    if (!row.plan.IsEmpty()) feature.SetGeometry(&row.plan);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return layer->CommitTransaction() == OGRERR_NONE;
}

bool GeoPackageWriter::Rows::write_roofs(GDALDataset* dataset, OGRSpatialReference* srs) const {
  OGRLayer* layer = dataset->CreateLayer("roofs", srs, wkbMultiPolygon25D, nullptr);
  if (!layer) return false;
  for (const char* name : {"building", "part"}) {
    if (!add_column(layer, name, OFTString)) return false;
  }
  for (const char* name : {"area_m2", "plan_area_m2", "slope_deg", "aspect_deg"}) {
    if (!add_column(layer, name, OFTReal)) return false;
  }
  if (layer->StartTransaction() != OGRERR_NONE) return false;
  for (const RoofRow& row : roofs) {
    OGRFeature feature(layer->GetLayerDefn());
    feature.SetField("building", utf8(row.building).c_str());
    feature.SetField("part", row.part.c_str());
    feature.SetField("area_m2", row.area);
    feature.SetField("plan_area_m2", row.plan_area);
    feature.SetField("slope_deg", row.slope);
    if (row.slope >= kLevel) feature.SetField("aspect_deg", row.aspect);
    feature.SetGeometry(&row.roof);
    if (layer->CreateFeature(&feature) != OGRERR_NONE) return false;
  }
  return layer->CommitTransaction() == OGRERR_NONE;
}

GeoPackageWriter::GeoPackageWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path), crs_(options.crs), rows_(std::make_unique<Rows>()) {}

GeoPackageWriter::~GeoPackageWriter() = default;

void GeoPackageWriter::append(const Building& building, const BuildingModel& model) {
  const GdalMessages messages;
  const double bottom = bottom_of(model);
  const std::vector<Cover> covers = covers_of(model);
  OGRMultiPolygon ground;
  for (const PartModel& part : model.parts) {
    const Solid* solid = finest_solid_without_slabs(part);
    if (!solid) continue;
    for (const Face& face : solid->faces) {
      if (is_on_the_ground(*solid, face, bottom)) {
        const OGRPolygon polygon = plan_polygon(*solid, face, model.origin);
        ground.addGeometry(&polygon);
      }
      const Eigen::Vector3d normal = face_vector(*solid, face).normalized();
      if (face.type != SurfaceType::kRoof || !(normal.z() > 1e-6)) continue;
      const Plane plane = plane_of(*solid, face, normal);
      Rows::RoofRow row{building.id,
                        part_name(part),
                        0.0,
                        0.0,
                        0.0,
                        0.0,
                        seen_roof(*solid, face, plane, model, covers)};
      if (row.roof.IsEmpty()) continue;
      row.plan_area = plan_area(row.roof);
      row.area = row.plan_area / normal.z();
      row.slope = kDegrees * std::atan2(normal.head<2>().norm(), normal.z());
      row.aspect = kDegrees * std::atan2(normal.x(), normal.y());
      if (row.aspect < 0.0) row.aspect += 360.0;
      rows_->roofs.push_back(std::move(row));
    }
  }
  rows_->buildings.push_back({building.id, table_attributes(building, model),
                              dump_json(attributes_json(building)["gable_derivation"]),
                              united(ground)});
}

void GeoPackageWriter::close() {
  const GdalMessages messages;
  // A GeoPackage carries the time of its last change, which would differ from run to run.
  const CPLConfigOptionSetter fixed_date("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z", true);
  MemoryFile memory(".gpkg");
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GPKG")->Create(
      memory.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr);
  OGRSpatialReference srs = ogr_from_crs(crs_);
  OGRSpatialReference* const known = crs_.empty() ? nullptr : &srs;
  if (!dataset || !rows_->write_buildings(dataset, known) || !rows_->write_roofs(dataset, known)) {
    if (dataset) GDALClose(dataset);
    throw Error(ExitCode::kInternal, file_.path() + ": could not be composed" + messages.suffix());
  }
  memory.close_and_write(dataset, &file_);
  file_.commit();
}

}  // namespace gable
