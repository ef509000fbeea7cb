#include <gable/engine/io/models/building_figures.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr double kSameLevel = 1e-3;

/// Six times the volume that a face spans with the origin.
double spanned6(const Solid& solid, const Face& face) {
  double sum = 0.0;
  for (const std::vector<int>& ring : face.rings) {
    for (size_t i = 2; i < ring.size(); ++i) {
      sum +=
          solid.vertices[ring[0]].dot(solid.vertices[ring[i - 1]].cross(solid.vertices[ring[i]]));
    }
  }
  return sum;
}

void add_deviations(const Building& building, Json* json) {
  if (!building.house || building.deviations.empty()) return;
  const House& house = *building.house;
  const auto deviation = [&](int rule, int parameter) {
    const auto& all = building.deviations;
    if (rule >= static_cast<int>(all.size()) || parameter >= static_cast<int>(all[rule].size())) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return all[rule][parameter];
  };
  const double azimuth = deviation(0, 0) * (180.0 / M_PI);
  if (std::isfinite(azimuth)) (*json)["gable_azimuth_sd_deg"] = azimuth;
  const auto lower = [](const Rule& a, const Rule& b) {
    return a[param::roof::kEaves] < b[param::roof::kEaves];
  };
  const auto lowest = std::min_element(house.roofs.begin(), house.roofs.end(), lower);
  if (lowest == house.roofs.end()) return;
  const double eaves = deviation(house.roof_block(static_cast<int>(lowest - house.roofs.begin())),
                                 param::roof::kEaves);
  if (std::isfinite(eaves)) (*json)["gable_eaves_sd_m"] = eaves;
}

}  // namespace

Eigen::Vector3d face_vector(const Solid& solid, const Face& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::vector<int>& ring : face.rings) {
    for (size_t i = 2; i < ring.size(); ++i) {
      sum += (solid.vertices[ring[i - 1]] - solid.vertices[ring[0]])
                 .cross(solid.vertices[ring[i]] - solid.vertices[ring[0]]);
    }
  }
  return 0.5 * sum;
}

bool is_on_the_ground(const Solid& solid, const Face& face, double bottom) {
  if (face.type != SurfaceType::kGround || face.rings.empty()) return false;
  return std::all_of(face.rings[0].begin(), face.rings[0].end(),
                     [&](int v) { return solid.vertices[v].z() < bottom + kSameLevel; });
}

double bottom_of(const BuildingModel& model) {
  double bottom = std::numeric_limits<double>::infinity();
  for (const PartModel& part : model.parts) {
    const Solid* solid = finest_solid_without_slabs(part);
    if (!solid) continue;
    for (const Eigen::Vector3d& p : solid->vertices) bottom = std::min(bottom, p.z());
  }
  return std::isfinite(bottom) ? bottom : 0.0;
}

Json table_attributes(const Building& building, const BuildingModel& model) {
  Json json = attributes_json(building);
  json.erase("gable_derivation");
  double plan = 0.0, roofs = 0.0, volume6 = 0.0;
  const double bottom = bottom_of(model);
  for (const PartModel& part : model.parts) {
    const Solid* solid = finest_solid_without_slabs(part);
    if (!solid) continue;
    for (const Face& face : solid->faces) {
      volume6 += spanned6(*solid, face);
      const double area = face_vector(*solid, face).norm();
      if (face.type == SurfaceType::kRoof) roofs += area;
      if (is_on_the_ground(*solid, face, bottom)) plan += area;
    }
  }
  json["gable_plan_area_m2"] = plan;
  json["gable_roof_area_m2"] = roofs;
  json["gable_volume_m3"] = volume6 / 6.0;
  add_deviations(building, &json);
  return json;
}

}  // namespace gable
