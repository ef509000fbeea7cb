#include <gable/engine/io/answers/annotations_file.h>
#include <gable/engine/io/answers/house_list_file.h>
#include <gable/engine/io/number_text.h>

#include <cmath>

namespace gable {
namespace {

using namespace annotation_json;

constexpr char kFormat[] = "gable validation houses";

// Nobody reads a place off a picture more exactly than this, metres.
constexpr double kStep = 0.05;

std::vector<Eigen::Vector2d> rounded_points(std::vector<Eigen::Vector2d> points) {
  for (Eigen::Vector2d& p : points) p = (p / kStep).array().round() * kStep;
  return points;
}

std::string house_line(const AnnotatedHouse& house) {
  std::string text = "{\"id\":" + quoted(house.id) + ",\"center\":";
  append_point(rounded_points({house.center})[0], 2, &text);
  text += ",\"azimuth\":" + rounded(house.azimuth, 5);
  text += ",\"foundation\":\"" + std::string(foundation_name(house.foundation)) + "\"";
  std::vector<std::vector<Eigen::Vector2d>> components, garages;
  for (const auto& c : house.components) components.push_back(rounded_points({c.begin(), c.end()}));
  for (const auto& ring : house.garages) garages.push_back(rounded_points(ring));
  text += ",\"components\":";
  append_rings(components, 2, &text);
  text += ",\"outline\":";
  append_points(rounded_points(house.outline), 2, &text);
  text += ",\"roofs\":";
  append_roofs(house.roofs, &text);
  text += ",\"dormers\":";
  append_points(rounded_points(house.dormers), 2, &text);
  text += ",\"chimneys\":";
  append_points(rounded_points(house.chimneys), 2, &text);
  text += ",\"garages\":";
  append_rings(garages, 2, &text);
  return text + ",\"confidence\":\"" + std::string(confidence_name(house.confidence)) + "\"}";
}

AnnotatedHouse house_from_json(const Json& json) {
  AnnotatedHouse house;
  const std::vector<double> center = numbers(member(json, "center"), "center", 2);
  house.center = {center[0], center[1]};
  house.azimuth = number(json, "azimuth");
  require(house.azimuth >= 0.0 && house.azimuth < 0.5 * M_PI,
          "\"azimuth\" does not lie in [0, pi/2)");
  house.foundation = foundation(json, "foundation");
  for (const auto& ring : rings(json, "components")) {
    require(ring.size() == 4, "\"components\" has a rectangle without 4 corners");
    house.components.push_back({ring[0], ring[1], ring[2], ring[3]});
  }
  house.outline = points(json, "outline");
  house.roofs = roofs(json, "roofs");
  house.dormers = points(json, "dormers");
  house.chimneys = points(json, "chimneys");
  house.garages = rings(json, "garages");
  const auto confidence = confidence_from_name(text(json, "confidence"));
  require(confidence.has_value(), "\"confidence\" is none of low, medium, high");
  house.confidence = *confidence;

  const std::string of = " of foundation " + std::string(foundation_name(house.foundation));
  const size_t rectangles = static_cast<size_t>(num_annotated_rectangles(house.foundation));
  require(house.components.size() == rectangles, "\"components\" has the wrong number" + of);
  require(house.roofs.size() == static_cast<size_t>(num_annotated_roofs(house.foundation)),
          "\"roofs\" has the wrong number" + of);
  const size_t corners = static_cast<size_t>(num_annotated_corners(house.foundation));
  require(house.outline.size() >= 3 && (corners == 0 || house.outline.size() == corners),
          "\"outline\" has the wrong number of corners" + of);
  return house;
}

}  // namespace

void write_annotations(const std::string& path, const AnnotatedTile& tile) {
  write_house_list(path, kFormat, tile, house_line);
}

AnnotatedTile read_annotations(const std::string& path) {
  return read_house_list<AnnotatedTile>(path, kFormat, house_from_json);
}

}  // namespace gable
