#pragma once

#include <gable/engine/reconstruct/building/building_options.h>
#include <gable/engine/reconstruct/building/reconstructed_building.h>
#include <gable/engine/reconstruct/first_values/detected_values.h>
#include <gable/residuals/height_image.h>

#include <string>

namespace gable {

/// Reconstructs one building from its heights: the house that `choose_house` finds, unless the
/// outline extruded to the median height (LoD 1.2) is clearly nearer to the heights, or no valid
/// solid can be made of the house. Then the planes of the roof closed over the outline, or where
/// these are no nearer than it or cannot be closed that extrusion, with the reason. All are
/// measured over the inside pixels, a miss counting as terrain, with what they cover beyond them
/// added. `outline` is the known outline in the image's local frame, or null: then it is traced
/// from the inside pixels. `detect` asks the detectors for first values; it may be empty. Always
/// returns a building.
ReconstructedBuilding reconstruct_building(const std::string& id, const HeightImage& image,
                                           const PlanPolygon* outline,
                                           const BuildingOptions& options,
                                           const DetectValues& detect = {});

}  // namespace gable
