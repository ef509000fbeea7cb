#include <gable/engine/io/models/building_json.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gable {
namespace {

Json rule_json(const Rule& rule, const std::vector<double>* deviations) {
  Json json;
  json["rule"] = rule_name(rule.kind);
  if (rule.component >= 0) json["component"] = rule.component;
  if (is_roof(rule.kind) && rule.kind != RuleKind::kRoofFlat) {
    json["ridge"] = rule.ridge == Axis::kX ? "x" : "y";
  }
  const auto specs = parameter_specs(rule.kind);
  Json& parameters = json["parameters"] = Json::object();
  for (size_t i = 0; i < specs.size(); ++i) {
    parameters[std::string(specs[i].name)] = rule.values[i];
  }
  if (deviations && deviations->size() == specs.size()) {
    Json& named = json["deviations"] = Json::object();
    for (size_t i = 0; i < specs.size(); ++i) {
      if (std::isfinite((*deviations)[i])) named[std::string(specs[i].name)] = (*deviations)[i];
    }
  }
  return json;
}

Json point_json(const Eigen::Vector3d& p) { return Json::array({p.x(), p.y(), p.z()}); }

Json ring_json(const std::vector<Eigen::Vector2d>& ring) {
  Json json = Json::array();
  for (const Eigen::Vector2d& p : ring) json.push_back(Json::array({p.x(), p.y()}));
  return json;
}

Json polygon_json(const PlanPolygon& polygon) {
  Json json;
  json["outer"] = ring_json(polygon.outer);
  Json& holes = json["holes"] = Json::array();
  for (const auto& ring : polygon.holes) holes.push_back(ring_json(ring));
  return json;
}

Json roof_json(const RoofPartition& roof) {
  Json json;
  Json& planes = json["planes"] = Json::array();
  for (const Plane& plane : roof.planes) {
    planes.push_back(Json::array({plane.a, plane.b, plane.c}));
  }
  Json& regions = json["regions"] = Json::array();
  for (const RoofRegion& region : roof.regions) {
    Json& entry = regions.emplace_back(polygon_json(region.polygon));
    entry["plane"] = region.plane;
  }
  return json;
}

/// Lowest and highest point of a roof.
std::pair<double, double> height_range(const RoofPartition& roof) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const RoofRegion& region : roof.regions) {
    for (const Eigen::Vector2d& p : region.polygon.outer) {
      low = std::min(low, roof.planes[region.plane].at(p));
      high = std::max(high, roof.planes[region.plane].at(p));
    }
  }
  return {low, high};
}

Json derivation_json(const Building& building) {
  Json json;
  if (!building.house) {
    json["origin"] = point_json(building.origin);
    json["base"] = building.base;
    json["foundation"] = foundation_name(Foundation::kC);
    json["height"] = building.height;
    json["outline"] = polygon_json(building.outline);
    if (building.roof) json["roof"] = roof_json(*building.roof);
    return json;
  }
  const House& house = *building.house;
  json["origin"] = point_json(house.origin);
  json["base"] = building.base;
  if (!building.walls.empty()) {
    json["walls"] = polygon_json(building.walls.polygon);
    json["walls"]["reach"] = building.walls.reach;
  }
  json["foundation"] = foundation_name(house.foundation);
  Json& rules = json["rules"] = Json::array();
  const auto derivation = house.derivation();
  for (size_t i = 0; i < derivation.size(); ++i) {
    rules.push_back(rule_json(*derivation[i],
                              i < building.deviations.size() ? &building.deviations[i] : nullptr));
  }
  return json;
}

/// The house's x axis as a bearing: degrees clockwise from grid north, in [0, 360).
double bearing_deg(const House& house) {
  const double bearing = std::fmod(90.0 - house.azimuth[0] * (180.0 / M_PI), 360.0);
  return bearing < 0.0 ? std::fmod(bearing + 360.0, 360.0) : bearing;
}

double ridge_height(const Rule& roof) {
  return roof[param::roof::kEaves] +
         (roof.kind == RuleKind::kRoofFlat ? 0.0 : roof[param::roof::kRise]);
}

}  // namespace

Json attributes_json(const Building& building) {
  Json json;
  json["gable_status"] = building_status_name(building.status);
  if (!building.reason.empty()) json["gable_reason"] = building.reason;
  Json roofs = Json::array();
  if (building.house) {
    const House& house = *building.house;
    double eaves = std::numeric_limits<double>::infinity();
    double ridge = -eaves;
    for (const Rule& roof : house.roofs) {
      roofs.push_back(roof_name(roof.kind));
      eaves = std::min(eaves, roof[param::roof::kEaves]);
      ridge = std::max(ridge, ridge_height(roof));
    }
    json["gable_foundation"] = foundation_name(house.foundation);
    json["gable_roofs"] = std::move(roofs);
    json["gable_azimuth_deg"] = bearing_deg(house);
    json["gable_eaves_m"] = eaves - building.base;
    json["gable_ridge_m"] = ridge - building.base;
    json["gable_dormers"] = house.dormers.size();
    json["gable_chimneys"] = house.chimneys.size();
    json["gable_garages"] = house.garages.size();
  } else {
    const auto [eaves, ridge] =
        building.roof ? height_range(*building.roof) : std::pair(building.height, building.height);
    json["gable_foundation"] = foundation_name(Foundation::kC);
    json["gable_roofs"] = std::move(roofs);
    json["gable_eaves_m"] = eaves - building.base;
    json["gable_ridge_m"] = ridge - building.base;
    if (building.roof) json["gable_planes"] = building.roof->planes.size();
    json["gable_dormers"] = 0;
    json["gable_chimneys"] = 0;
    json["gable_garages"] = 0;
  }
  json["gable_mad_m"] = building.quality.mad;
  json["gable_rmse_m"] = building.quality.rmse;
  if (building.quality.time_ms >= 0.0) json["gable_time_ms"] = building.quality.time_ms;
  json["gable_derivation"] = derivation_json(building);
  return json;
}

std::string dump_json(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gable
