#pragma once

#include <gable/engine/detectors/crop_foundation.h>
#include <gable/engine/detectors/rectangle_candidates.h>

#include <array>
#include <vector>

namespace gable {

/// Corners of a polygon that may be undetected, at most; none in a row, so each of its coordinates
/// is known by one corner or two.
inline constexpr int kMostMissingCorners = 2;

/// The best L polygons from the peaks of their corners by role, best first (NPR section 4.1): every
/// choice of six corners in the order of their roles along the boundary, or of five or four with
/// the missing ones inferred from their neighbours. Coordinates shared by two corners are their
/// means; the corners agree. Wings and steps are at least 2 pixels. Scored by IoU with `mask` and
/// by the corners' values, missing ones 0. Among them is also the mask's bounds less the best
/// rectangle at one corner, so that there is an answer for any mask of at least 4 x 4 pixels.
std::vector<CropFoundation> l_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                         const CandidateOptions& options = {});

/// The same for U polygons of eight corners, or seven or six; the answer without corners is the
/// mask's bounds less the best rectangle at one side, for any mask of at least 6 x 6 pixels.
std::vector<CropFoundation> u_candidates(const CornerPeaks& peaks, const CropBits& mask,
                                         const CandidateOptions& options = {});

}  // namespace gable
