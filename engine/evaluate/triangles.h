#pragma once

#include <gable/grammar/solid/solid.h>

namespace gable {

/// Number of triangles of a triangulation of all faces without new vertices: a polygon of n
/// vertices in r rings takes n + 2 (r - 1) - 2.
inline int count_triangles(const Solid& solid) {
  int triangles = 0;
  for (const Face& face : solid.faces) {
    int vertices = 0;
    for (const auto& ring : face.rings) vertices += static_cast<int>(ring.size());
    triangles += vertices + 2 * (static_cast<int>(face.rings.size()) - 1) - 2;
  }
  return triangles;
}

}  // namespace gable
