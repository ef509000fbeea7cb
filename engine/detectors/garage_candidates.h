#pragma once

#include <gable/engine/detectors/crop_foundation.h>

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

namespace gable {

struct GarageOptions {
  double threshold = 0.5;  ///< least value of the map, (0, 1] (NPR section 4.4)
  int least_diameter = 3;  ///< of connected pixels: the longer side of their bounds, [1, 64]
  /// An L's concave corner is at least this far inside of the bounds, crop pixels, [1, 32].
  int least_inset = 4;
  double l_gain = 0.02;  ///< IoU that an L must gain on the rectangle, [0, 1]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const GarageOptions& options);

/// A garage or another flat thing beside a house, as the detectors see it.
struct CropGarage {
  /// One rectangle; or two of an L, along x and along y, which share the outer corner.
  std::vector<CropRectangle> rectangles;
  Eigen::Vector2d side = Eigen::Vector2d::Zero();  ///< the L's outer corner, house directions
  double iou = 0.0;                                ///< with the pixels that it was fitted to
};

/// The pixels of a map that reach the threshold.
CropBits pixels_above(std::span<const float> map, double threshold);

/// The pieces of a set that hang together over edges or corners of pixels, in reading order of
/// their first pixels.
std::vector<CropBits> connected_pieces(const CropBits& bits);

/// Garages in the garage map, in reading order (NPR section 4.4): of every connected piece that is
/// large enough the better, by IoU with its pixels, of the bounds and of the bounds less a
/// rectangle at one corner. Of a piece that lies for the most part within `mask` only what is in it
/// counts.
std::vector<CropGarage> garage_candidates(std::span<const float> map, const CropBits& mask,
                                          const GarageOptions& options = {});

}  // namespace gable
