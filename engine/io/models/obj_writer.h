#pragma once

#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/model_writer.h>

namespace gable {

/// Wavefront OBJ: metres, Z up, one group per building with the finest solid of every part. A
/// comment at the top holds the local origin, the world point that coordinates are relative to.
/// Faces use the material names roof, wall and ground; faces with holes are cut into triangles.
class ObjWriter : public ModelWriter {
 public:
  ObjWriter(const std::string& path, const ModelWriterOptions& options);
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  AtomicFile file_;
  Eigen::Vector3d local_origin_;
  long num_vertices_ = 0;
};

}  // namespace gable
