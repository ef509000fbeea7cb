#pragma once

#include <gable/grammar/solid/solid.h>
#include <gable/training/scans/face_plane.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// Which face of a coarse model of a building (a block model: walls, flat tops, a ground) stands
/// for a piece of a detailed one:
///  - a wall: the nearest coarse wall with a similar normal (20 degrees) that is within half a
///    metre in plan; where there is none it stands between roof parts, and belongs to the roof;
///  - a roof: the coarse roof over or under it, or else the nearest in plan; a ground likewise.
class HullFaces {
 public:
  /// Keeps a reference to the coarse model.
  explicit HullFaces(const Solid& hull);

  /// For a small piece with this centre and outward unit normal; -1 where the coarse model has no
  /// face of the kind.
  int face_for(SurfaceType type, const Eigen::Vector3d& centre,
               const Eigen::Vector3d& normal) const;

 private:
  const Solid& hull_;
  std::vector<FacePlane> planes_;
};

}  // namespace gable
