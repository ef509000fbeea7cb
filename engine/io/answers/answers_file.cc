#include <gable/engine/io/answers/answers_file.h>
#include <gable/engine/io/answers/house_list_file.h>
#include <gable/engine/io/number_text.h>

namespace gable {
namespace {

using namespace annotation_json;

constexpr char kFormat[] = "gable annotation answers";

// Crop pixels: proposals are no better than a tenth of one.
constexpr int kCropDecimals = 1;

std::string house_text(const HouseAnswer& house) {
  std::string text = "{\"id\":" + quoted(house.id) + ",\n \"sheet\":" + quoted(house.sheet);
  text += ",\n \"frame\":{\"azimuth\":";
  append_number(house.frame.azimuth, &text);
  text += ",\"north_west\":";
  append_numbers(std::vector<double>{house.frame.north_west.x(), house.frame.north_west.y()},
                 &text);
  text += ",\"pixel\":";
  append_number(house.frame.pixel, &text);
  text += "},\n \"proposed\":" + quoted(house.proposed);
  text += ",\n \"foundation\":\"" + std::string(foundation_name(house.foundation)) + "\"";
  text += ",\n \"rectangles\":";
  append_list(house.rectangles, &text, [](const CropRectangle& r, std::string* out) {
    *out += "[" + rounded(r.x0, kCropDecimals) + "," + rounded(r.y0, kCropDecimals) + "," +
            rounded(r.x1, kCropDecimals) + "," + rounded(r.y1, kCropDecimals) + "]";
  });
  text += ",\n \"polygon\":";
  append_points(house.polygon, kCropDecimals, &text);
  text += ",\n \"roofs\":";
  append_roofs(house.roofs, &text);
  text += ",\n \"dormers\":";
  append_points(house.dormers, kCropDecimals, &text);
  text += ",\n \"chimneys\":";
  append_points(house.chimneys, kCropDecimals, &text);
  text += ",\n \"garages\":";
  append_rings(house.garages, kCropDecimals, &text);
  text += ",\n \"confidence\":";
  text += house.confidence ? "\"" + std::string(confidence_name(*house.confidence)) + "\"" : "null";
  return text + ",\n \"reviewed\":" + (house.reviewed ? "true" : "false") + "}";
}

HouseAnswer house_from_json(const Json& json) {
  HouseAnswer house;
  house.sheet = text(json, "sheet");
  const Json& frame = member(json, "frame");
  house.frame.azimuth = number(frame, "azimuth");
  const std::vector<double> north_west = numbers(member(frame, "north_west"), "north_west", 2);
  house.frame.north_west = {north_west[0], north_west[1]};
  house.frame.pixel = number(frame, "pixel");
  require(house.frame.pixel > 0.0, "\"pixel\" is not positive");
  house.proposed = text(json, "proposed");
  house.foundation = foundation(json, "foundation");
  const Json& rectangles = member(json, "rectangles");
  require(rectangles.is_array(), "\"rectangles\" is no list");
  for (const Json& item : rectangles) {
    const std::vector<double> r = numbers(item, "rectangles", 4);
    house.rectangles.push_back({r[0], r[2], r[1], r[3]});
  }
  house.polygon = points(json, "polygon");
  house.roofs = roofs(json, "roofs");
  house.dormers = points(json, "dormers");
  house.chimneys = points(json, "chimneys");
  house.garages = rings(json, "garages");
  if (!member(json, "confidence").is_null()) {
    house.confidence = confidence_from_name(text(json, "confidence"));
    require(house.confidence.has_value(), "\"confidence\" is none of low, medium, high, null");
  }
  const Json& reviewed = member(json, "reviewed");
  require(reviewed.is_boolean(), "\"reviewed\" is neither true nor false");
  house.reviewed = reviewed.get<bool>();
  return house;
}

}  // namespace

void write_answers(const std::string& path, const HouseAnswers& answers) {
  write_house_list(path, kFormat, answers, house_text);
}

HouseAnswers read_answers(const std::string& path) {
  return read_house_list<HouseAnswers>(path, kFormat, house_from_json);
}

}  // namespace gable
