#include <gable/engine/error.h>
#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/readable.h>

#include <cstdlib>
#include <fstream>
#include <unordered_set>

namespace gable {
namespace {

/// The last part of ".../crs/EPSG/0/NNNN"; 0 for anything else.
int epsg_from_url(const std::string& url) {
  const size_t at = url.find("/EPSG/");
  const size_t slash = url.rfind('/');
  return at == std::string::npos ? 0 : std::atoi(url.c_str() + slash + 1);
}

class FileReader {
 public:
  explicit FileReader(const std::string& path) : path_(path) {}

  BuildingFile read() {
    require_readable(path_);
    std::ifstream stream(path_, std::ios::binary);
    if (path_.ends_with(".jsonl")) {
      std::string line;
      for (int number = 1; std::getline(stream, line); ++number) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        read_document(Json::parse(line, nullptr, false), path_ + ":" + std::to_string(number));
      }
    } else {
      read_document(Json::parse(stream, nullptr, false), path_);
    }
    if (file_.buildings.empty()) {
      throw Error(ExitCode::kBadInput,
                  path_ + ": holds no building; give a CityJSON file written by gable");
    }
    return std::move(file_);
  }

 private:
  void read_document(const Json& json, const std::string& where) {
    if (json.is_discarded()) {
      throw Error(ExitCode::kBadInput, where + ": is not valid JSON; the file may be cut short");
    }
    const std::string type = json.is_object() && json.contains("type") && json["type"].is_string()
                                 ? json["type"].get<std::string>()
                                 : "";
    const bool is_document = type == "CityJSON" || type == "CityJSONFeature";
    if (!is_document || !json.contains("CityObjects") || !json["CityObjects"].is_object()) {
      throw Error(ExitCode::kBadInput, where + ": is not CityJSON");
    }
    const Json::json_pointer reference("/metadata/referenceSystem");
    if (type == "CityJSON" && json.contains(reference) && json[reference].is_string()) {
      file_.epsg = epsg_from_url(json[reference].get<std::string>());
    }
    for (const auto& [id, object] : json["CityObjects"].items()) {
      if (!object.is_object() || !object.contains("type") || object["type"] != "Building") continue;
      const std::string building = where + ": building \"" + id + "\"";
      if (!ids_.insert(id).second) {
        throw Error(ExitCode::kBadInput, building + " occurs twice");
      }
      file_.buildings.push_back(building_from_attributes(
          id, object.contains("attributes") ? object["attributes"] : Json(), building));
    }
  }

  std::string path_;
  BuildingFile file_;
  std::unordered_set<std::string> ids_;
};

}  // namespace

BuildingFile read_buildings(const std::string& path) { return FileReader(path).read(); }

}  // namespace gable
