#pragma once

#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gable/grammar/wing_polygons.h>
#include <gable/residuals/height_image.h>

#include <string>
#include <vector>

namespace gable {

/// A block of a house as its roof planes show it.
struct PlaneBlock {
  RoofedRectangle roofed;   ///< in the house frame of an azimuth
  std::vector<int> planes;  ///< of the scale that it was read from
  int pixels = 0;           ///< of these planes
  std::string footprint_origin, roof_origin;
};

/// When planes make a block. Lengths in metres.
struct PlaneBlockOptions {
  double flat_slope = 0.1;         ///< flatter planes are flat roofs, (0, 1)
  double least_area = 6.0;         ///< of a block's planes in plan, square metres, > 0
  double least_height = 1.5;       ///< of a block over its ground, >= 0
  double ridge_gap = 1.5;          ///< between a slope's pixels and its ridge, > 0
  double slope_ratio = 0.4;        ///< two slopes of one ridge differ by at most this share, (0, 1)
  double least_half_slope = 0.25;  ///< of a slope to be half a gable, > 0
  double coplanar = 0.35;          ///< slopes one above the other by less are one, > 0
  double least_fill = 0.75;        ///< share of a flat roof's rectangle; else it is split, (0, 1)
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const PlaneBlockOptions& options);

/// Reads blocks off the planes of a house, those of most pixels first:
///
///   gables  two planes that fall to opposite sides with nearly one slope, their crease (the ridge)
///           between them; its height and the slope give the eaves at the rectangle's edge
///   hips    a plane across such a ridge at its end: where the three meet, the ridge ends
///   half    a slope without counterpart beyond whose upper edge the building goes on, which box
///           dormers and the like hide: with its mirror image
///   flat    planes that are level, and slopes that belong to nothing else; what fills its
///   rectangle
///           badly is two
///
/// Rectangles are the extents of the planes' pixels, the outermost fiftieth on either side left
/// out, half a cell more. `cell`: distance of the pixels that were looked at, metres; `azimuth`:
/// radians from local x to house x. Slopes that run diagonally in the house frame belong to no
/// block.
std::vector<PlaneBlock> plane_blocks(const HeightImage& image, const HouseScale& scale, double cell,
                                     double azimuth, const PlaneBlockOptions& options = {});

}  // namespace gable
