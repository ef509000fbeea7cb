#pragma once

#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace gable {

/// Distances of points to the surface of solids, by their triangles.
class SurfaceDistance {
 public:
  explicit SurfaceDistance(const std::vector<Solid>& solids);

  /// Metres; infinite where the solids have no faces.
  double operator()(const Eigen::Vector3d& p) const;

 private:
  struct Triangle {
    std::array<Eigen::Vector3d, 3> corners;
    Eigen::AlignedBox3d box;
  };
  std::vector<Triangle> triangles_;
};

}  // namespace gable
