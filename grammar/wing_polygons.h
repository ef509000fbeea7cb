#pragma once

#include <gable/grammar/house.h>

#include <Eigen/Core>

namespace gable {

/// A rectangle of a house frame under a roof rule: the common currency of foundations.
struct RoofedRectangle {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;  ///< metres
  Rule roof;
};

/// A side of the house frame: one of (+-1, 0), (0, +-1), or a corner (+-1, +-1).
using Side = Eigen::Vector2d;

/// The L of two rectangles that share the outer corner `corner` of their common box: `along_x` is
/// the wing along x, `along_y` the one along y. The house's frame is turned by quarter turns so
/// that the corner comes to the low ends of both axes; its azimuth is `azimuth` plus these turns.
House l_house(const RoofedRectangle& along_x, const RoofedRectangle& along_y, const Side& corner,
              double azimuth);

/// The U of a base and two wings that share its outer corners and stand to its side `open`.
House u_house(const RoofedRectangle& base, const RoofedRectangle& wing_a,
              const RoofedRectangle& wing_b, const Side& open, double azimuth);

/// The I, II, III or N of one, two, three, or four and more rectangles.
House blocks_house(const std::vector<RoofedRectangle>& blocks, double azimuth);

/// The rectangles and roofs of a house's components, in its own frame.
std::vector<RoofedRectangle> roofed_rectangles(const House& house);

}  // namespace gable
