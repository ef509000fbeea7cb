#pragma once

#include <gable/engine/detectors/crop_foundation.h>
#include <gable/engine/detectors/peaks.h>

#include <array>
#include <span>
#include <vector>

namespace gable {

/// The peaks of the four corner maps of one foundation type, by crop_map::RectangleCorner or
/// crop_map::PolygonCorner.
using CornerPeaks = std::array<std::vector<Peak>, 4>;

/// A rectangle that corners span.
struct RectangleCandidate {
  CropRectangle rectangle;
  /// By crop_map::RectangleCorner: which of the type's peaks it is, or -1, and its value, or 0.
  std::array<int, 4> peaks = {-1, -1, -1, -1};
  std::array<double, 4> values{};

  /// Mean value of the corners' peaks, undetected ones count 0.
  double corners() const { return 0.25 * (values[0] + values[1] + values[2] + values[3]); }
};

/// Rectangles spanned by corners of different types, each edge at the mean of its corners, which
/// agree (NPR section 4.1, where three corners give one): by four, by three, by two opposite ones,
/// by two of one edge whose opposite edge is that of the mask between them, and the mask's own
/// bounds. No sides below 2 pixels. Of alike ones that with the best corners; sorted by corners.
/// Nothing where neither the mask nor corners have anything.
std::vector<RectangleCandidate> rectangle_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                                     const CandidateOptions& options = {});

/// How sets of rectangles are found.
struct RectangleSetOptions {
  CandidateOptions candidates;
  int singles = 40;  ///< rectangles that are combined, the best by `single_score`, [3, 200]
  /// Every rectangle of a set covers at least this share of the set alone, [0, 1].
  double own_share = 0.06;
  /// Rectangles of a set hang together over gaps up to this, crop pixels, [0, 64].
  double gap = 2.0;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RectangleSetOptions& options);

/// The best sets of `count` (1-3) rectangles by IoU of their union with the mask and their corners,
/// of which a peak counts for one rectangle only, best first: an I, II or III. Of a II or III the
/// largest rectangle comes first. For a II or III there may be none.
std::vector<CropFoundation> rectangle_sets(std::span<const RectangleCandidate> candidates,
                                           int count, const CropBits& mask,
                                           const RectangleSetOptions& options = {});

}  // namespace gable
