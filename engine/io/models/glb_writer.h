#pragma once

#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/models/model_writer.h>

#include <array>
#include <cstdint>
#include <vector>

namespace gable {

/// Binary glTF 2.0: the finest solid of every part, gathered into one mesh per semantic class
/// (roofs, walls, ground) with a plain colour. Coordinates are metres, Z up, relative to the whole
/// metres of the anchor; the root node turns Z up into glTF's Y up and names the anchor and the
/// reference system in its extras. Kept in memory until close.
class GlbWriter : public ModelWriter {
 public:
  GlbWriter(const std::string& path, const ModelWriterOptions& options);
  void append(const Building& building, const BuildingModel& model) override;
  void close() override;

 private:
  /// Vertices of one semantic class; each face has its own, because normals differ.
  struct Mesh {
    std::vector<float> positions, normals;
    std::vector<uint32_t> triangles;
  };

  AtomicFile file_;
  ModelWriterOptions options_;
  Eigen::Vector3d local_origin_;
  std::array<Mesh, 3> meshes_;  ///< by SurfaceType
};

}  // namespace gable
