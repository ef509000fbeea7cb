#pragma once

#include <gable/engine/detectors/crop_bits.h>
#include <gable/engine/detectors/crop_rectangle.h>
#include <gable/grammar/house.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace gable {

/// The largest distance between edges of the same side, crop pixels.
double largest_step(const CropRectangle& a, const CropRectangle& b);

/// The largest distance between edges of the same side, crop pixels.
double largest_step(const CropRectangle& a, const CropRectangle& b);

/// The pixels whose centres lie in the rectangle.
CropBits bits_of(const CropRectangle& rectangle);

/// The tight rectangle around the pixels of a set; width 0 where it is empty.
CropRectangle bounds_of(const CropBits& bits);

/// A foundation as the detectors see it.
struct CropFoundation {
  Foundation foundation = Foundation::kI;
  /// I, II, III: the components. L: the wing along x, the wing along y, which share the outer
  /// corner. U: the base and both wings, which share its outer corners.
  std::vector<CropRectangle> rectangles;
  /// L: the outer corner, U: the open side; house directions as in grammar/wing_polygons.h: x as in
  /// the crop, y up. Zero otherwise.
  Eigen::Vector2d side = Eigen::Vector2d::Zero();
  double iou = 0.0;      ///< against the pixels that it should cover, [0, 1]
  double corners = 0.0;  ///< mean value of the corners' peaks, undetected ones count 0, [0, 1]
  double log_probability = 0.0;  ///< of the foundation's type

  /// The pixels of all rectangles.
  CropBits bits() const;
};

/// How candidates of one foundation type are told apart.
struct CandidateOptions {
  /// Of the mean corner beside the IoU, [0, 10]. Masks have trees and sheds in them: weighed alike,
  /// corners find more foundations than with a smaller weight.
  double corner_weight = 1.0;
  int at_most = 3;  ///< candidates that are returned, >= 1
  /// Candidates whose edges all differ by less are alike, crop pixels, [0, 64].
  double distinct = 1.5;
  /// Corners of one edge agree to this, crop pixels, [0.1, 64]: a few degrees that the azimuth is
  /// off turn an edge of 40 pixels by 2.
  double agreement = 4.0;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const CandidateOptions& options);

/// What candidates of one type are sorted by.
inline double candidate_score(const CropFoundation& candidate, const CandidateOptions& options) {
  return candidate.iou + options.corner_weight * candidate.corners;
}

/// Sorts candidates of one type by score, best first (stable), and keeps the best distinct ones.
void keep_best(const CandidateOptions& options, std::vector<CropFoundation>* candidates);

}  // namespace gable
