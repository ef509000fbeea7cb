#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/models/cityjson_writer.h>

namespace gable {
namespace {

Eigen::Vector3d translate_of(const ModelWriterOptions& options) {
  return options.anchor.array().floor();
}

/// Everything before the members of "CityObjects".
std::string head(const ModelWriterOptions& options, const CityObjects* extent) {
  Json json;
  json["type"] = "CityJSON";
  json["version"] = "2.0";
  const Eigen::Vector3d t = translate_of(options);
  json["transform"]["scale"] = {kCityJsonStep, kCityJsonStep, kCityJsonStep};
  json["transform"]["translate"] = {t.x(), t.y(), t.z()};
  Json metadata = Json::object();
  if (extent && extent->num_vertices() > 0) {
    const Eigen::Vector3d low = extent->min(), high = extent->max();
    metadata["geographicalExtent"] = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }
  if (options.crs.epsg != 0) metadata["referenceSystem"] = crs_url(options.crs);
  if (!metadata.empty()) json["metadata"] = std::move(metadata);
  std::string text = dump_json(json);
  text.back() = ',';
  return text + R"("CityObjects":{)";
}

}  // namespace

CityJsonSeqWriter::CityJsonSeqWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path), translate_(translate_of(options)) {
  file_.write(head(options, nullptr) + R"(},"vertices":[]})" + "\n");
}

void CityJsonSeqWriter::append(const Building& building, const BuildingModel& model) {
  CityObjects objects(translate_);
  objects.add(building, model);
  file_.write(R"({"type":"CityJSONFeature","id":)" + dump_json(building.id) +
              R"(,"CityObjects":{)" + objects.objects() + R"(},"vertices":[)" + objects.vertices() +
              "]}\n");
}

void CityJsonSeqWriter::close() { file_.commit(); }

CityJsonWriter::CityJsonWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path), options_(options), objects_(translate_of(options)) {}

void CityJsonWriter::append(const Building& building, const BuildingModel& model) {
  objects_.add(building, model);
}

void CityJsonWriter::close() {
  file_.write(head(options_, &objects_));
  file_.write(objects_.objects());
  file_.write(R"(},"vertices":[)");
  file_.write(objects_.vertices());
  file_.write("]}\n");
  file_.commit();
}

}  // namespace gable
