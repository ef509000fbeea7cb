#pragma once

#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A polygon of a boundary and the surface it lies in.
struct SurfacePiece {
  std::vector<std::vector<int>> rings;
  SurfaceType type = SurfaceType::kRoof;
  int surface = 0;  ///< pieces of one type and number are coplanar and face the same side
};

/// A closed boundary in pieces that meet edge to edge.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<SurfacePiece> pieces;
};

/// Joins neighbouring pieces of one surface into single polygons, then removes the vertices that
/// only lie along a straight edge. Returns nothing where the pieces are not closed and 2-manifold
/// along every edge. A surface whose union would touch itself keeps its pieces.
std::optional<Solid> merge_pieces(const SurfaceMesh& mesh);

}  // namespace gable
