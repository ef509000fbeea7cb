#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/reconstruct/building/reconstructed_building.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// Refines a house against its heights; house.origin must be image->origin. The start is kept, with
/// a reason, where refinement does not lower the cost of its last stage or leaves no valid solid.
/// The inside pixels, which quality is measured over, become those that the result covers.
ReconstructedBuilding refine_building(const Building& start, const RefinementOptions& options,
                                      HeightImage* image);

}  // namespace gable
