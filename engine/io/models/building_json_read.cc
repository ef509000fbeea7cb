#include <gable/engine/error.h>
#include <gable/engine/io/models/building_json.h>

#include <cmath>
#include <limits>
#include <string_view>

namespace gable {
namespace {

/// Reads members and complains about them with the building's name in front.
class Reader {
 public:
  explicit Reader(std::string where) : where_(std::move(where)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ExitCode::kBadInput, where_ + ": " + what);
  }

  const Json& member(const Json& json, const std::string& key) const {
    const auto it = json.is_object() ? json.find(key) : json.end();
    if (!json.is_object() || it == json.end()) fail("gable_derivation lacks \"" + key + "\"");
    return *it;
  }

  double number(const Json& json, const std::string& what) const {
    if (!json.is_number() || !std::isfinite(json.get<double>())) fail(what + " is not a number");
    return json.get<double>();
  }

  std::string text(const Json& json, const std::string& what) const {
    if (!json.is_string()) fail(what + " is not a text");
    return json.get<std::string>();
  }

  const Json& list(const Json& json, const std::string& what) const {
    if (!json.is_array()) fail(what + " is not a list");
    return json;
  }

  Eigen::Vector3d point(const Json& json, const std::string& what) const {
    if (list(json, what).size() != 3) fail(what + " is not three numbers");
    return {number(json[0], what), number(json[1], what), number(json[2], what)};
  }

  std::vector<Eigen::Vector2d> ring(const Json& json) const {
    std::vector<Eigen::Vector2d> points;
    for (const Json& p : list(json, "a ring of the outline")) {
      if (list(p, "a point of the outline").size() != 2) fail("a point is not two numbers");
      points.emplace_back(number(p[0], "a coordinate"), number(p[1], "a coordinate"));
    }
    if (points.size() < 3) fail("a ring of the outline has fewer than three points");
    return points;
  }

 private:
  std::string where_;
};

Rule read_rule(const Reader& reader, const Json& json, std::vector<double>* deviations) {
  const std::string name = reader.text(reader.member(json, "rule"), "a rule's name");
  Rule rule;
  if (!rule_kind_from_name(name, &rule.kind)) reader.fail("no rule is called \"" + name + "\"");
  if (json.contains("component")) {
    const Json& component = json["component"];
    if (!component.is_number_integer()) reader.fail("a component is not an integer");
    rule.component = component.get<int>();
  }
  if (json.contains("ridge")) {
    const std::string ridge = reader.text(json["ridge"], "a ridge");
    if (ridge != "x" && ridge != "y") reader.fail("a ridge is neither \"x\" nor \"y\"");
    rule.ridge = ridge == "x" ? Axis::kX : Axis::kY;
  }
  const Json& parameters = reader.member(json, "parameters");
  const Json* named = json.contains("deviations") ? &json["deviations"] : nullptr;
  if (named && !named->is_object()) reader.fail("the deviations of " + name + " are no object");
  const auto specs = parameter_specs(rule.kind);
  for (size_t i = 0; i < specs.size(); ++i) {
    const std::string key(specs[i].name);
    rule.values[i] = reader.number(reader.member(parameters, key), name + "." + key);
    if (!named) continue;
    deviations->push_back(named->contains(key) ? reader.number((*named)[key], "a deviation")
                                               : std::numeric_limits<double>::quiet_NaN());
  }
  return rule;
}

/// Appends a rule to the list of its kind.
void place(const Rule& rule, House* house) {
  switch (rule.kind) {
    case RuleKind::kAzimuth:
      house->azimuth = rule;
      return;
    case RuleKind::kFootprintI:
    case RuleKind::kFootprintL:
    case RuleKind::kFootprintU:
      house->footprints.push_back(rule);
      return;
    case RuleKind::kRoofFlat:
    case RuleKind::kRoofGable:
    case RuleKind::kRoofHip:
    case RuleKind::kRoofMansard:
      house->roofs.push_back(rule);
      return;
    case RuleKind::kDormer:
      house->dormers.push_back(rule);
      return;
    case RuleKind::kChimney:
      house->chimneys.push_back(rule);
      return;
    case RuleKind::kGarageI:
    case RuleKind::kGarageL:
      house->garages.push_back(rule);
      return;
  }
}

void read_house(const Reader& reader, const Json& derivation, Foundation foundation,
                Building* building) {
  House house;
  house.foundation = foundation;
  house.origin = reader.point(reader.member(derivation, "origin"), "origin");
  bool any_deviation = false;
  RuleKind last = RuleKind::kAzimuth;
  const Json& rules = reader.list(reader.member(derivation, "rules"), "rules");
  for (const Json& json : rules) {
    std::vector<double> deviations;
    const Rule rule = read_rule(reader, json, &deviations);
    const bool roofs = is_roof(last) && is_roof(rule.kind);
    const bool garages = last >= RuleKind::kGarageI && rule.kind >= RuleKind::kGarageI;
    if (rule.kind < last && !roofs && !garages) reader.fail("the rules are out of order");
    last = rule.kind;
    any_deviation = any_deviation || !deviations.empty();
    building->deviations.push_back(std::move(deviations));
    place(rule, &house);
  }
  if (!any_deviation) building->deviations.clear();
  if (!is_well_formed(house) || rules.size() != house.derivation().size()) {
    reader.fail("the rules do not form a house of foundation " +
                std::string(foundation_name(foundation)));
  }
  building->house = std::move(house);
}

PlanPolygon read_polygon(const Reader& reader, const Json& json, const std::string& what) {
  PlanPolygon polygon;
  polygon.outer = reader.ring(reader.member(json, "outer"));
  if (json.contains("holes")) {
    for (const Json& hole : reader.list(json["holes"], "the holes of " + what)) {
      polygon.holes.push_back(reader.ring(hole));
    }
  }
  return polygon;
}

RoofPartition read_roof(const Reader& reader, const Json& json) {
  RoofPartition roof;
  for (const Json& plane : reader.list(reader.member(json, "planes"), "planes")) {
    const Eigen::Vector3d values = reader.point(plane, "a plane");
    roof.planes.push_back({values.x(), values.y(), values.z()});
  }
  for (const Json& entry : reader.list(reader.member(json, "regions"), "regions")) {
    const Json& plane = reader.member(entry, "plane");
    RoofRegion region;
    region.plane = plane.is_number_unsigned() && plane.get<size_t>() < roof.planes.size()
                       ? plane.get<int>()
                       : -1;
    if (region.plane < 0) reader.fail("a region of the roof has none of its planes");
    region.polygon = read_polygon(reader, entry, "a region");
    roof.regions.push_back(std::move(region));
  }
  return roof;
}

double optional_number(const Reader& reader, const Json& attributes, const char* key,
                       double missing) {
  return attributes.contains(key) ? reader.number(attributes[key], key) : missing;
}

}  // namespace

Building building_from_attributes(const std::string& id, const Json& attributes,
                                  const std::string& where) {
  const Reader reader(where);
  if (!attributes.is_object() || !attributes.contains("gable_derivation")) {
    reader.fail("has no attribute gable_derivation; only models written by gable can be read");
  }
  Building building;
  building.id = id;
  if (attributes.contains("gable_reason")) {
    building.reason = reader.text(attributes["gable_reason"], "gable_reason");
  }
  building.quality.mad = optional_number(reader, attributes, "gable_mad_m", 0.0);
  building.quality.rmse = optional_number(reader, attributes, "gable_rmse_m", 0.0);
  building.quality.time_ms = optional_number(reader, attributes, "gable_time_ms", -1.0);

  const Json& derivation = attributes["gable_derivation"];
  building.base = reader.number(reader.member(derivation, "base"), "base");
  const std::string name = reader.text(reader.member(derivation, "foundation"), "foundation");
  Foundation foundation = Foundation::kC;
  if (!foundation_from_name(name, &foundation)) {
    reader.fail("no foundation is called \"" + name + "\"");
  }
  if (foundation != Foundation::kC) {
    read_house(reader, derivation, foundation, &building);
    if (derivation.contains("walls")) {
      const Json& walls = derivation["walls"];
      building.walls.polygon = read_polygon(reader, walls, "the walls");
      building.walls.reach = reader.number(reader.member(walls, "reach"), "reach");
    }
    return building;
  }
  building.status = BuildingStatus::kExtrusion;
  building.origin = reader.point(reader.member(derivation, "origin"), "origin");
  building.height = reader.number(reader.member(derivation, "height"), "height");
  building.outline = read_polygon(reader, reader.member(derivation, "outline"), "the outline");
  if (derivation.contains("roof")) {
    building.status = BuildingStatus::kPlanes;
    building.roof = read_roof(reader, derivation["roof"]);
  }
  return building;
}

}  // namespace gable
