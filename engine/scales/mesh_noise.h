#pragma once

#include <gable/engine/scan.h>

namespace gable {

/// How far the vertices of a mesh typically lie off the surface that their neighbours show, metres:
/// from the distances of vertices to the planes through the vertices around them, the median taken
/// for a normal distribution. Near 0 for meshes that were designed, where most vertices lie amid
/// flat or gently curved facets, or there are few of them (fewer than 1000: 0).
double mesh_noise(const Scan& mesh);

}  // namespace gable
