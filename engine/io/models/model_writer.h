#pragma once

#include <gable/engine/io/crs.h>
#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>

#include <Eigen/Core>
#include <memory>
#include <string>

namespace gable {

struct ModelWriterOptions {
  Crs crs;  ///< of the buildings; without an EPSG code no reference system is written
  /// World point that coordinates in the file are kept relative to (CityJSON's translate, the
  /// local origin of OBJ and GLB). Any point near the data; its whole metres are used.
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  /// KML: heights count from the viewer's own terrain (altitudeMode relativeToGround) instead of
  /// the heights' zero (absolute).
  bool kml_on_terrain = false;
};

/// A file of building models being written, one building after the other. It appears under its
/// name at `close`; destroyed before that it leaves nothing. The same buildings in the same order
/// give the same bytes.
class ModelWriter {
 public:
  virtual ~ModelWriter() = default;
  /// Ids must differ between buildings. Throws Error (kCannotWrite).
  virtual void append(const Building& building, const BuildingModel& model) = 0;
  /// Throws Error (kCannotWrite).
  virtual void close() = 0;
};

/// Opens a file by the end of its name: .jsonl CityJSONSeq, .json CityJSON, .obj, .glb, .kml, .kmz,
/// .gpkg. The folder is tried at once. Memory does not grow with the number of buildings for
/// .jsonl, .obj and .kml. Throws Error: kUsage for another name, or where .kml and .kmz lack a
/// reference system; kCannotWrite.
std::unique_ptr<ModelWriter> open_model_writer(const std::string& path,
                                               const ModelWriterOptions& options);

}  // namespace gable
