#pragma once

#include <gable/engine/house_answer.h>
#include <gable/engine/io/models/building.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// A reconstructed building as an answer to be corrected: its crop is the one that the detectors
/// see, turned by the house's azimuth; an extrusion is C, turned by what `azimuth_candidates` finds
/// first. Of L and U, one roof type stands for all wings: hip where any is, else gable where any
/// is. The image must be the building's.
HouseAnswer proposed_answer(const Building& building, const HeightImage& image);

}  // namespace gable
