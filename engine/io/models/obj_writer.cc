#include <gable/engine/io/models/obj_writer.h>
#include <gable/grammar/solid/triangulate.h>

#include <cstdio>

namespace gable {
namespace {

constexpr SurfaceType kTypes[] = {SurfaceType::kGround, SurfaceType::kWall, SurfaceType::kRoof};

const char* material(SurfaceType type) {
  if (type == SurfaceType::kRoof) return "roof";
  return type == SurfaceType::kWall ? "wall" : "ground";
}

/// A group's name may hold neither white space nor line ends.
std::string group_name(std::string id) {
  for (char& c : id) {
    if (static_cast<unsigned char>(c) <= ' ') c = '_';
  }
  return id.empty() ? "_" : id;
}

template <typename Indices>
void append_face(const Indices& indices, long offset, std::string* text) {
  *text += 'f';
  for (const int i : indices) *text += ' ' + std::to_string(offset + i + 1);
  *text += '\n';
}

}  // namespace

ObjWriter::ObjWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path), local_origin_(options.anchor.array().floor()) {
  char text[256];
  std::snprintf(text, sizeof text,
                "# gable: metres, Z up; world = vertex + local origin\n"
                "# local origin: %.0f %.0f %.0f\n",
                local_origin_.x(), local_origin_.y(), local_origin_.z());
  file_.write(text);
  if (options.crs.epsg != 0) {
    file_.write("# reference system: EPSG:" + std::to_string(options.crs.epsg) + "\n");
  }
}

void ObjWriter::append(const Building& building, const BuildingModel& model) {
  std::string text = "g " + group_name(building.id) + "\n";
  const Eigen::Vector3d shift = model.origin - local_origin_;
  for (const PartModel& part : model.parts) {
    const Solid& solid = finest_solid(part);
    for (const Eigen::Vector3d& vertex : solid.vertices) {
      const Eigen::Vector3d p = vertex + shift;
      char line[128];
      std::snprintf(line, sizeof line, "v %.4f %.4f %.4f\n", p.x(), p.y(), p.z());
      text += line;
    }
    for (const SurfaceType type : kTypes) {
      bool named = false;
      for (const Face& face : solid.faces) {
        if (drawn_type(part.role, face.type) != type) continue;
        if (!named) text += std::string("usemtl ") + material(type) + "\n";
        named = true;
        if (face.rings.size() == 1) {
          append_face(face.rings[0], num_vertices_, &text);
          continue;
        }
        for (const auto& triangle : triangulate(solid, face)) {
          append_face(triangle, num_vertices_, &text);
        }
      }
    }
    num_vertices_ += static_cast<long>(solid.vertices.size());
  }
  file_.write(text);
}

void ObjWriter::close() { file_.commit(); }

}  // namespace gable
