#pragma once

#include <gable/engine/scales/planar_shape.h>

#include <string>

namespace gable {

/// Writes the polygons of a scale as Wavefront OBJ: metres, z up, one group "shape_N" per shape
/// that has polygons, N its number. A polygon without holes is one face; one with holes is cut into
/// triangles, as OBJ knows no holes. Where coordinates are large (beyond 10 km), they are relative
/// to a local origin that a comment at the top states: world = vertex + local origin. Throws Error
/// (kCannotWrite).
void write_polygon_obj(const std::string& path, const ScaleShapes& shapes);

/// The same as text.
std::string polygon_obj(const ScaleShapes& shapes);

}  // namespace gable
