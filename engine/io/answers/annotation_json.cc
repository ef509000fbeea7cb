#include <gable/engine/drawing/fixed.h>
#include <gable/engine/io/answers/annotation_json.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/readable.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace gable::annotation_json {
namespace {

double finite(const Json& json, const std::string& key) {
  require(json.is_number() && std::isfinite(json.get<double>()),
          "\"" + key + "\" has something that is no number");
  return json.get<double>();
}

Eigen::Vector2d point(const Json& json, const std::string& key) {
  require(json.is_array() && json.size() == 2, "\"" + key + "\" has a point that is not [x, y]");
  return {finite(json[0], key), finite(json[1], key)};
}

std::vector<Eigen::Vector2d> point_list(const Json& json, const std::string& key) {
  require(json.is_array(), "\"" + key + "\" is no list of points");
  std::vector<Eigen::Vector2d> points;
  for (const Json& item : json) points.push_back(point(item, key));
  return points;
}

}  // namespace

void require(bool holds, const std::string& problem) {
  if (!holds) throw std::runtime_error(problem);
}

const Json& member(const Json& json, const std::string& key) {
  require(json.is_object(), "is no object");
  const auto it = json.find(key);
  require(it != json.end(), "lacks \"" + key + "\"");
  return *it;
}

std::string text(const Json& json, const std::string& key) {
  const Json& value = member(json, key);
  require(value.is_string(), "\"" + key + "\" is no text");
  return value.get<std::string>();
}

double number(const Json& json, const std::string& key) { return finite(member(json, key), key); }

std::vector<double> numbers(const Json& json, const std::string& key, size_t count) {
  require(json.is_array() && json.size() == count,
          "\"" + key + "\" has not " + std::to_string(count) + " numbers");
  std::vector<double> values;
  for (const Json& item : json) values.push_back(finite(item, key));
  return values;
}

std::vector<Eigen::Vector2d> points(const Json& json, const std::string& key) {
  return point_list(member(json, key), key);
}

std::vector<std::vector<Eigen::Vector2d>> rings(const Json& json, const std::string& key) {
  const Json& list = member(json, key);
  require(list.is_array(), "\"" + key + "\" is no list of polygons");
  std::vector<std::vector<Eigen::Vector2d>> rings;
  for (const Json& item : list) {
    rings.push_back(point_list(item, key));
    require(rings.back().size() >= 3, "\"" + key + "\" has a polygon of fewer than 3 corners");
  }
  return rings;
}

Foundation foundation(const Json& json, const std::string& key) {
  Foundation foundation = Foundation::kC;
  const std::string name = text(json, key);
  require(foundation_from_name(name, &foundation) && foundation != Foundation::kMany,
          "\"" + key + "\": \"" + name + "\" is none of I, II, III, L, U, C");
  return foundation;
}

std::vector<RoofType> roofs(const Json& json, const std::string& key) {
  const Json& list = member(json, key);
  require(list.is_array(), "\"" + key + "\" is no list");
  std::vector<RoofType> roofs;
  for (const Json& item : list) {
    const auto type = roof_type_from_name(item.is_string() ? item.get<std::string>() : "");
    require(type.has_value(), "\"" + key + "\" has something that is none of flat, gable, hip");
    roofs.push_back(type.value());
  }
  return roofs;
}

AnnotationSource source(const Json& json) {
  AnnotationSource source;
  source.tile = text(json, "tile");
  if (json.contains("dtm")) source.dtm = text(json, "dtm");
  if (json.contains("footprints")) source.footprints = text(json, "footprints");
  source.crs = text(json, "crs");
  source.gsd = number(json, "gsd");
  require(source.gsd > 0.0, "\"gsd\" is not positive");
  return source;
}

std::string source_text(const AnnotationSource& source) {
  std::string out = "\"tile\":" + quoted(source.tile);
  if (!source.dtm.empty()) out += ",\"dtm\":" + quoted(source.dtm);
  if (!source.footprints.empty()) out += ",\"footprints\":" + quoted(source.footprints);
  out += ",\"crs\":" + quoted(source.crs) + ",\"gsd\":";
  append_number(source.gsd, &out);
  return out;
}

Json read(const std::string& path, const std::string& format) {
  require_readable(path);
  std::ifstream stream(path, std::ios::binary);
  const Json json = Json::parse(stream);
  require(json.is_object() && json.contains("format") && json["format"] == format,
          "is no file of " + format);
  require(member(json, "version") == 1, "is of another version of gable");
  return json;
}

std::string rounded(double value, int decimals) {
  std::string text = fixed(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

void append_point(const Eigen::Vector2d& point, int decimals, std::string* out) {
  *out += "[" + rounded(point.x(), decimals) + "," + rounded(point.y(), decimals) + "]";
}

void append_points(const std::vector<Eigen::Vector2d>& points, int decimals, std::string* out) {
  append_list(points, out, [decimals](const Eigen::Vector2d& point, std::string* text) {
    append_point(point, decimals, text);
  });
}

void append_rings(const std::vector<std::vector<Eigen::Vector2d>>& rings, int decimals,
                  std::string* out) {
  append_list(rings, out, [decimals](const std::vector<Eigen::Vector2d>& ring, std::string* text) {
    append_points(ring, decimals, text);
  });
}

void append_roofs(const std::vector<RoofType>& roofs, std::string* out) {
  append_list(roofs, out, [](RoofType type, std::string* text) {
    *text += "\"" + std::string(roof_type_name(type)) + "\"";
  });
}

std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gable::annotation_json
