#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// Semantic class of a face (CityGML boundary surfaces).
enum class SurfaceType { kGround, kWall, kRoof };

/// A planar polygon of a solid. rings[0] is the outer ring, anticlockwise seen from outside the
/// solid; the others are holes, clockwise. Entries are indices into Solid::vertices; the first
/// vertex is not repeated.
struct Face {
  std::vector<std::vector<int>> rings;
  SurfaceType type = SurfaceType::kRoof;
};

/// A closed, 2-manifold, outward-oriented boundary in metres. No two vertices coincide.
struct Solid {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
};

}  // namespace gable
