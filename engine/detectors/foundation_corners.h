#pragma once

#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/grammar/house.h>

#include <array>
#include <vector>

namespace gable {

/// The corners of a house's foundation as its heat maps show them, in the frame of a crop:
/// RectangleCorner types by the corner's place in the crop for I, II, III (four a block), by role
/// for L (6) and U (8). `image_origin`: world origin of the height image that the crop was made of.
std::vector<CropCorner> foundation_corners(const House& house, const HouseCrop& crop,
                                           const Eigen::Vector3d& image_origin);

/// The corners of a component's rectangle in crop pixels, ordered as RectangleCorner says by their
/// place in the crop; `component` indexes House::roofs.
std::array<Eigen::Vector2d, 4> component_corners(const House& house, int component,
                                                 const HouseCrop& crop,
                                                 const Eigen::Vector3d& image_origin);

/// A point of a house's own frame in crop pixels.
Eigen::Vector2d crop_from_own_frame(const House& house, const Eigen::Vector2d& point,
                                    const HouseCrop& crop, const Eigen::Vector3d& image_origin);

}  // namespace gable
