#pragma once

#include <gable/grammar/solid/solid.h>

#include <array>
#include <vector>

namespace gable {

/// Triangles (indices into solid.vertices, oriented as the face) that cover a face and use all of
/// its vertices, those in the middle of a straight edge too, so that neighbouring faces still meet
/// vertex to vertex. n + 2 (r - 1) - 2 triangles for n vertices in r rings. Ear clipping, with
/// holes joined to the outer ring by bridges (Held 2001 describes the method).
std::vector<std::array<int, 3>> triangulate(const Solid& solid, const Face& face);

}  // namespace gable
