#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/grammar/outlined_house.h>

#include <Eigen/Core>
#include <optional>

namespace gable {

/// What is seen from above at a point.
struct SurfacePart {
  /// Index into BuildingSurface::field()'s blocks, or of a region of the roof; 0 for an extrusion,
  /// -1: the ground.
  int block = -1;
  BlockRole role = BlockRole::kComponent;  ///< of that block
};

/// The heights of a reconstructed building in the local frame of an image (world less `origin`,
/// metres), whatever way the building came out.
class BuildingSurface {
 public:
  BuildingSurface(const Building& building, const Eigen::Vector3d& origin);

  /// Height above origin.z() at a point, averaged over a support (metres), over a terrain of height
  /// `ground` above origin.z().
  double height(const Eigen::Vector2d& point, double support, double ground) const;

  SurfacePart part(const Eigen::Vector2d& point) const;

  /// The house's height field; nullptr for all else. Its local frame is this one less
  /// `offset()`.
  const HeightField* field() const { return house_ ? &house_->field() : nullptr; }
  const Eigen::Vector2d& offset() const { return offset_; }

 private:
  double height_at(const Eigen::Vector2d& local, double ground) const;

  const Building& building_;
  std::optional<OutlinedHouse> house_;
  Eigen::Vector2d offset_;  ///< the building's origin in the image's local frame
  double offset_z_;
};

}  // namespace gable
