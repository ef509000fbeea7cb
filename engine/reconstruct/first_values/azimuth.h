#pragma once

#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// A direction of the building's walls, modulo a quarter turn.
struct AzimuthCandidate {
  double azimuth = 0.0;   ///< radians in [0, pi / 2), from local x to house x, anticlockwise
  double strength = 0.0;  ///< concentration of the directions behind it, in [0, 1]
};

/// First values of the azimuth without learning: the directions in which the building's outline
/// (the smoothed mask) and its roof (the smoothed heights inside) rise, as angles modulo a quarter
/// turn, combined as a circular mean. Returns the mean of both, then those of the outline and of
/// the roof alone where they differ from it by more than `separation` radians; at least one.
std::vector<AzimuthCandidate> azimuth_candidates(const HeightImage& image, double separation);

}  // namespace gable
