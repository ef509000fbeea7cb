#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/number_text.h>
#include <gable/engine/io/shapes/shapes_json.h>

namespace gable {
namespace {

using Ring = std::vector<Eigen::Vector3d>;

void append_ring(const Ring& ring, std::string* text) {
  append_list(ring, text, [](const Eigen::Vector3d& p, std::string* t) { append_numbers(p, t); });
}

void append_polygon(const SpacePolygon& polygon, std::string* text) {
  *text += "{\"outer\":";
  append_ring(polygon.outer, text);
  *text += ",\"holes\":";
  append_list(polygon.holes, text, append_ring);
  *text += '}';
}

void append_shape(int number, const PlanarShape& shape, std::string* text) {
  *text += "{\"shape\":";
  append_number(number, text);
  *text += ",\"normal\":";
  append_numbers(shape.plane.normal(), text);
  *text += ",\"offset\":";
  append_number(shape.plane.offset(), text);
  *text += ",\"centroid\":";
  append_numbers(shape.centroid, text);
  *text += ",\"inliers\":";
  append_number(shape.inliers, text);
  *text += ",\"area\":";
  append_number(shape.area, text);
  *text += ",\"rms\":";
  append_number(shape.rms, text);
  *text += ",\"polygons\":";
  append_list(shape.polygons, text, append_polygon);
  *text += '}';
}

}  // namespace

std::string shapes_json(const ScaleShapes& shapes) {
  std::string text = "{\"configuration\":";
  append_number(shapes.configuration, &text);
  text += ",\"elements\":";
  append_number(shapes.shape_of.size(), &text);
  text += ",\"coverage\":";
  append_number(shapes.coverage, &text);
  text += ",\"rms\":";
  append_number(shapes.rms, &text);
  text += ",\"shapes\":[";
  for (size_t i = 0; i < shapes.shapes.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    append_shape(static_cast<int>(i), shapes.shapes[i], &text);
  }
  return text + "]}\n";
}

void write_shapes_json(const std::string& path, const ScaleShapes& shapes) {
  write_file_atomically(path, shapes_json(shapes));
}

}  // namespace gable
