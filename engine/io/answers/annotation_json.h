#pragma once

#include <gable/engine/annotated_house.h>
#include <gable/engine/house_answer.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gable {

/// Readers of the members that files of annotations share. All throw std::runtime_error that names
/// the member, `key`.
namespace annotation_json {

using Json = nlohmann::ordered_json;

void require(bool holds, const std::string& problem);
const Json& member(const Json& json, const std::string& key);
std::string text(const Json& json, const std::string& key);
double number(const Json& json, const std::string& key);
std::vector<double> numbers(const Json& json, const std::string& key, size_t count);
std::vector<Eigen::Vector2d> points(const Json& json, const std::string& key);
std::vector<std::vector<Eigen::Vector2d>> rings(const Json& json, const std::string& key);
Foundation foundation(const Json& json, const std::string& key);
std::vector<RoofType> roofs(const Json& json, const std::string& key);

/// "tile", "dtm", "footprints", "crs" and "gsd"; "dtm" and "footprints" may be missing.
AnnotationSource source(const Json& json);
/// The same members as text, without braces.
std::string source_text(const AnnotationSource& source);

/// The file's contents, of format `format`, version 1. Throws Error (kNoInput), or what
/// `in_file` turns into one.
Json read(const std::string& path, const std::string& format);

/// Appends "[x,y]" with `decimals` digits, trailing zeros dropped.
void append_point(const Eigen::Vector2d& point, int decimals, std::string* out);
void append_points(const std::vector<Eigen::Vector2d>& points, int decimals, std::string* out);
void append_rings(const std::vector<std::vector<Eigen::Vector2d>>& rings, int decimals,
                  std::string* out);
void append_roofs(const std::vector<RoofType>& roofs, std::string* out);
/// A text as JSON, with its quotes.
std::string quoted(const std::string& text);
/// The shortest text of a number rounded to `decimals` digits.
std::string rounded(double value, int decimals);

}  // namespace annotation_json
}  // namespace gable
