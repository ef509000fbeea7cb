#pragma once

#include <ceres/manifold.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace gable {

/// A plane in Hesse normal form, in any metric frame: the points p with normal . p = offset.
/// Invariant: |normal| = 1 to 1e-9. Offsets are best conditioned in a frame near the data.
struct OrientedPlane {
  /// normal x, y, z (unit), then offset (metres): one Ceres parameter block.
  Eigen::Vector4d values{0.0, 0.0, 1.0, 0.0};

  OrientedPlane() = default;
  OrientedPlane(const Eigen::Vector3d& normal, double offset) { values << normal, offset; }

  auto normal() const { return values.head<3>(); }
  double offset() const { return values[3]; }
  /// Metres, positive on the side the normal points to.
  double signed_distance(const Eigen::Vector3d& p) const { return normal().dot(p) - offset(); }
};

inline constexpr int kPlaneSize = 4;

/// The set of planes as Ceres walks on it: the normal on the unit sphere, the offset free, so three
/// degrees of freedom. The caller (or the problem it is given to) owns it.
ceres::Manifold* make_plane_manifold();

}  // namespace gable
