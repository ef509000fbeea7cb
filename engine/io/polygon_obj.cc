#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/polygon_obj.h>
#include <gable/grammar/solid/triangulate.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Below, a viewer's single precision still tells millimetres apart.
constexpr double kLarge = 1e4;

/// Zero, or the lowest corner of all polygons in whole metres where a coordinate is large.
Eigen::Vector3d local_origin(const ScaleShapes& shapes) {
  Eigen::AlignedBox3d box;
  for (const PlanarShape& shape : shapes.shapes) {
    for (const SpacePolygon& polygon : shape.polygons) {
      for (const Eigen::Vector3d& p : polygon.outer) box.extend(p);
    }
  }
  if (box.isEmpty()) return Eigen::Vector3d::Zero();
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (largest <= kLarge) return Eigen::Vector3d::Zero();
  return box.min().array().floor();
}

template <typename Corners>
void append_face(const Corners& corners, size_t offset, std::string* text) {
  *text += 'f';
  for (const int corner : corners) {
    *text += ' ';
    append_number(offset + corner + 1, text);
  }
  *text += '\n';
}

/// The rings as a face of a solid that has nothing else.
Solid as_solid(const SpacePolygon& polygon) {
  Solid solid;
  Face& face = solid.faces.emplace_back();
  const auto add = [&](const std::vector<Eigen::Vector3d>& ring) {
    auto& indices = face.rings.emplace_back();
    for (const Eigen::Vector3d& p : ring) {
      indices.push_back(static_cast<int>(solid.vertices.size()));
      solid.vertices.push_back(p);
    }
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) {
    if (hole.size() >= 3) add(hole);
  }
  return solid;
}

void append_polygon(const SpacePolygon& polygon, const Eigen::Vector3d& origin,
                    size_t* num_vertices, std::string* text) {
  const Solid solid = as_solid(polygon);
  for (const Eigen::Vector3d& vertex : solid.vertices) {
    *text += 'v';
    for (const double value : vertex - origin) {
      *text += ' ';
      append_number(value, text);
    }
    *text += '\n';
  }
  const Face& face = solid.faces[0];
  if (face.rings.size() == 1) {
    append_face(face.rings[0], *num_vertices, text);
  } else {
    for (const auto& triangle : triangulate(solid, face)) {
      append_face(triangle, *num_vertices, text);
    }
  }
  *num_vertices += solid.vertices.size();
}

}  // namespace

std::string polygon_obj(const ScaleShapes& shapes) {
  const Eigen::Vector3d origin = local_origin(shapes);
  std::string text = "# gable: metres, z up; world = vertex + local origin\n# local origin:";
  for (const double value : origin) {
    text += ' ';
    append_number(value, &text);
  }
  text += '\n';
  size_t num_vertices = 0;
  for (size_t i = 0; i < shapes.shapes.size(); ++i) {
    const auto& polygons = shapes.shapes[i].polygons;
    if (polygons.empty()) continue;
    text += "g shape_" + std::to_string(i) + "\n";
    for (const SpacePolygon& polygon : polygons) {
      if (polygon.outer.size() >= 3) append_polygon(polygon, origin, &num_vertices, &text);
    }
  }
  return text;
}

void write_polygon_obj(const std::string& path, const ScaleShapes& shapes) {
  write_file_atomically(path, polygon_obj(shapes));
}

}  // namespace gable
