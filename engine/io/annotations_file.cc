#include <gable/engine/error.h>
#include <gable/engine/io/annotation_json.h>
#include <gable/engine/io/annotations_file.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>

#include <cmath>
#include <set>

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
  std::string text = "{\"format\":\"" + std::string(kFormat) +
                     "\",\"version\":1," + source_text(tile.source) + ",\n\"houses\":[";
  for (size_t i = 0; i < tile.houses.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + house_line(tile.houses[i]);
  }
  write_file_atomically(path, text + "]}\n");
}

AnnotatedTile read_annotations(const std::string& path) {
  AnnotatedTile tile;
  std::string who;
  try {
    const Json json = annotation_json::read(path, kFormat);
    tile.source = source(json);
    const Json& houses = member(json, "houses");
    require(houses.is_array(), "\"houses\" is no list");
    std::set<std::string> ids;
    for (const Json& item : houses) {
      who = "a house ";
      const std::string id = text(item, "id");
      who = id + ": ";
      require(ids.insert(id).second, "stands there twice");
      tile.houses.push_back(house_from_json(item));
      tile.houses.back().id = id;
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ExitCode::kBadInput, path + ": " + who + error.what() +
                                         "; correct it or write it anew with gable annotate");
  }
  return tile;
}

}  // namespace gable
