#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/shapes/polygon_obj.h>
#include <gable/engine/io/shapes/ring_triangles.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// The rings as seen against the plane's normal.
std::vector<std::vector<Eigen::Vector2d>> flattened(
    const std::vector<const std::vector<Eigen::Vector3d>*>& rings, const Eigen::Vector3d& normal) {
  int drop = 0;  // the axis they are seen along
  normal.cwiseAbs().maxCoeff(&drop);
  int u = (drop + 1) % 3, v = (drop + 2) % 3;
  if (normal[drop] < 0.0) std::swap(u, v);
  const Eigen::Vector3d& origin = rings[0]->front();
  std::vector<std::vector<Eigen::Vector2d>> out(rings.size());
  for (size_t i = 0; i < rings.size(); ++i) {
    for (const Eigen::Vector3d& p : *rings[i]) {
      out[i].emplace_back(p[u] - origin[u], p[v] - origin[v]);
    }
  }
  return out;
}

void append_polygon(const SpacePolygon& polygon, const Eigen::Vector3d& normal,
                    const Eigen::Vector3d& origin, size_t* num_vertices, std::string* text) {
  std::vector<const std::vector<Eigen::Vector3d>*> rings = {&polygon.outer};
  for (const auto& hole : polygon.holes) {
    if (hole.size() >= 3) rings.push_back(&hole);
  }
  size_t size = 0;
  for (const auto* ring : rings) {
    for (const Eigen::Vector3d& vertex : *ring) {
      *text += 'v';
      for (const double value : vertex - origin) {
        *text += ' ';
        append_number(value, text);
      }
      *text += '\n';
    }
    size += ring->size();
  }
  if (rings.size() == 1) {
    std::vector<int> corners(size);
    std::iota(corners.begin(), corners.end(), 0);
    append_face(corners, *num_vertices, text);
  } else {
    for (const auto& triangle : triangulate_rings(flattened(rings, normal))) {
      append_face(triangle, *num_vertices, text);
    }
  }
  *num_vertices += size;
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
      if (polygon.outer.size() < 3) continue;
      append_polygon(polygon, shapes.shapes[i].plane.normal(), origin, &num_vertices, &text);
    }
  }
  return text;
}

void write_polygon_obj(const std::string& path, const ScaleShapes& shapes) {
  write_file_atomically(path, polygon_obj(shapes));
}

}  // namespace gable
