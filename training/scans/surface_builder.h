#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <Eigen/Geometry>
#include <vector>

namespace gable {

/// Belongs to whichever plane bottom-up merging joins it to.
inline constexpr int kTouching = -1;

/// Puts a LabelledSurface together from planar polygons. Planes of the three scales form a tree:
/// every detail belongs to one plane of the structure, every one of these to one plane of the hull.
/// Where a parent is left open (kTouching) it is the one that bottom-up merging by RMS distance
/// reaches first (attach_planes), so that what is not said is what a trajectory would do.
class SurfaceBuilder {
 public:
  using Ring = std::vector<Eigen::Vector3d>;

  /// New planes; numbers count from 0 at every scale.
  int add_hull() { return num_hulls_++; }
  int add_structure(int hull = kTouching);
  int add_detail(int structure = kTouching);

  /// Adds a planar polygon to a detail's plane. `outer` runs anticlockwise seen from outside,
  /// repeated and collinear points are allowed; `holes` run either way, inside the outer ring.
  void add_polygon(int detail, const Ring& outer, const std::vector<Ring>& holes = {});
  /// The same as a detail of its own; returns its number.
  int add_face(int structure, const Ring& outer, const std::vector<Ring>& holes = {});

  /// Where all polygons added from now on are placed: scene_from_object. A mirroring one turns
  /// their order around.
  void set_pose(const Eigen::Affine3d& pose) { pose_ = pose; }
  const Eigen::Affine3d& pose() const { return pose_; }

  /// The surface, with planes renumbered without gaps. Details count as touching within
  /// `contact` metres.
  LabelledSurface build(double contact) const;

 private:
  Eigen::Affine3d pose_ = Eigen::Affine3d::Identity();
  int num_hulls_ = 0;
  std::vector<int> hull_of_;       // per structure
  std::vector<int> structure_of_;  // per detail
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<int> detail_of_;  // per triangle
};

}  // namespace gable
