#pragma once

#include <gable/engine/reconstruct/first_values/house_scales.h>

#include <optional>

namespace gable {

/// The direction of a house's walls as its roof planes have it.
struct PlaneAzimuth {
  double azimuth = 0.0;   ///< radians in [0, pi / 2), from local x to house x, anticlockwise
  double strength = 0.0;  ///< concentration of the directions behind it, in [0, 1]
  int planes = 0;         ///< how many planes it is the mean of
};

/// The mean of the directions in which planes fall, as angles modulo a quarter turn, each weighted
/// by its pixels and its squared slope, which its direction is as certain by; planes more than 15
/// degrees off are left out of a second mean. None where all planes are flatter than 6 degrees or
/// steeper than 63, or where their directions do not agree.
std::optional<PlaneAzimuth> plane_azimuth(const HouseScale& scale);

}  // namespace gable
