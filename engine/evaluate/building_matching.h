#pragma once

#include <gable/grammar/raster.h>

#include <cstddef>
#include <vector>

namespace gable {

/// A truth building and the model building that stands for it.
struct BuildingMatch {
  int building = -1;  ///< index of the model building, -1: the truth building was missed
  double iou = 0.0;   ///< intersection over union of the two footprints in cells; 0: missed
};

/// Matches buildings one to one by the IoU of their footprints, best first, from the owners of the
/// cells (-1: none; see ModelSurface). Ties go to the smaller indices. One entry per truth
/// building.
std::vector<BuildingMatch> match_buildings(const Raster<int>& model_owner, int num_buildings,
                                           const Raster<int>& truth_owner, int num_truth);

}  // namespace gable
