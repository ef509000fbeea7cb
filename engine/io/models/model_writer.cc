#include <gable/engine/error.h>
#include <gable/engine/io/models/cityjson_writer.h>
#include <gable/engine/io/models/geopackage_writer.h>
#include <gable/engine/io/models/glb_writer.h>
#include <gable/engine/io/models/kml_writer.h>
#include <gable/engine/io/models/model_writer.h>
#include <gable/engine/io/models/obj_writer.h>

#include <string_view>

namespace gable {

std::unique_ptr<ModelWriter> open_model_writer(const std::string& path,
                                               const ModelWriterOptions& options) {
  const auto ends_with = [&path](std::string_view end) { return path.ends_with(end); };
  if (ends_with(".jsonl")) return std::make_unique<CityJsonSeqWriter>(path, options);
  if (ends_with(".json")) return std::make_unique<CityJsonWriter>(path, options);
  if (ends_with(".obj")) return std::make_unique<ObjWriter>(path, options);
  if (ends_with(".glb")) return std::make_unique<GlbWriter>(path, options);
  if (ends_with(".kml") || ends_with(".kmz")) return std::make_unique<KmlWriter>(path, options);
  if (ends_with(".gpkg")) return std::make_unique<GeoPackageWriter>(path, options);
  throw Error(ExitCode::kUsage,
              path +
                  ": the kind of model file is not known by this name; end it "
                  "with .city.jsonl, .city.json, .obj, .glb, .kml, .kmz or .gpkg");
}

}  // namespace gable
