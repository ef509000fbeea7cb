#pragma once

#include <gable/engine/detectors/crop_foundation.h>
#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/detectors/garage_candidates.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/detectors/peaks.h>
#include <gable/engine/detectors/rectangle_candidates.h>

#include <string>
#include <vector>

namespace gable {

struct FoundationOptions {
  int per_foundation = 3;  ///< hypotheses of one type, >= 1
  int at_most = 8;         ///< hypotheses in all, >= 1
  /// Types below are not looked at, [0, 1]; the most probable type always is.
  double least_probability = 0.01;
  /// How much a difference in score weighs beside one in log-probability, [0, 100].
  double score_weight = 5.0;
  /// Corners, of which no map has many. Below the paper's threshold of 0.5, since a doubtful corner
  /// is better than a missing one, and candidates are weighed by the values of theirs.
  PeakOptions peaks = {.threshold = 0.1, .radius = 2, .at_most = 6};
  RectangleSetOptions sets;
  GarageOptions garages;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const FoundationOptions& options);

/// The best foundations of a crop by log P(type) + score_weight * (IoU + corner_weight * corners),
/// best first, C left out. The IoU is against the building's mask without the pixels of garages
/// (unless that leaves less than half of it), since a foundation ends where they begin. Sets of
/// rectangles and polygons are those of rectangle_candidates.h and polygon_candidates.h. Nothing
/// where the mask is empty; otherwise an I is looked at where no other type yields anything.
std::vector<CropFoundation> foundation_hypotheses(const HouseCrop& crop, const CropAnswer& answer,
                                                  const FoundationOptions& options = {});

}  // namespace gable
