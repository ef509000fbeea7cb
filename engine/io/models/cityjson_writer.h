#pragma once

#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/city_objects.h>
#include <gable/engine/io/models/model_writer.h>

namespace gable {

/// CityJSONSeq 2.0: a header line, then one CityJSONFeature per building.
class CityJsonSeqWriter : public ModelWriter {
 public:
  CityJsonSeqWriter(const std::string& path, const ModelWriterOptions& options);
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  AtomicFile file_;
  Eigen::Vector3d translate_;
};

/// CityJSON 2.0: all buildings in one object, written at close.
class CityJsonWriter : public ModelWriter {
 public:
  CityJsonWriter(const std::string& path, const ModelWriterOptions& options);
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  AtomicFile file_;
  ModelWriterOptions options_;
  CityObjects objects_;
};

}  // namespace gable
