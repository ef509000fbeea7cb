#pragma once

#include <gable/engine/house_answer.h>

#include <string>

namespace gable {

/// An answer as a building in the world. Checked: numbers of rectangles, roofs and corners for the
/// foundation, rectangles that are none or do not touch, L and U whose edges are not along the axes
/// of the crop (corners off by up to a pixel are pulled straight) or turn the wrong way, points far
/// outside the crop, a missing confidence. Throws Error (kBadInput), one line that starts with
/// `where` (file name) and the id.
AnnotatedHouse annotated_from_answer(const HouseAnswer& answer, const std::string& where);

/// The outline that an answer means, crop pixels: its polygon, or where it has none the one around
/// its rectangles. Empty where the rectangles do not touch.
std::vector<Eigen::Vector2d> outline_of_answer(const HouseAnswer& answer);

/// An annotated building in a frame of its own, as a crop around its outline would have it.
HouseAnswer answer_from_annotated(const AnnotatedHouse& house);

}  // namespace gable
