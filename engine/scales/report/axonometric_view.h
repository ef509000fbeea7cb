#pragma once

#include <Eigen/Core>
#include <span>

namespace gable {

/// A parallel projection of space, z up, onto a picture: seen from high above a long side, a little
/// from its corner.
struct AxonometricView {
  int width = 0;                                       ///< pixels
  int height = 0;                                      ///< pixels
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();    ///< of the picture, unit, level
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();       ///< of the picture, unit
  Eigen::Vector3d toward = -Eigen::Vector3d::UnitY();  ///< the eye, unit
  Eigen::Vector3d center = Eigen::Vector3d::Zero();    ///< of the picture, metres
  double pixels_per_meter = 1.0;

  /// Columns from the left, rows from above (pixels, pixel centres at integers), and how far toward
  /// the eye (metres).
  Eigen::Vector3d project(const Eigen::Vector3d& point) const;
};

/// The view that holds the points, but for single far outliers, with a narrow margin. The same for
/// all pictures of a scan, so that they can be compared. Width and height are at least 16 pixels.
AxonometricView view_of(std::span<const Eigen::Vector3d> points, int width, int height);

/// The same view at another size.
AxonometricView resized(const AxonometricView& view, int width, int height);

}  // namespace gable
