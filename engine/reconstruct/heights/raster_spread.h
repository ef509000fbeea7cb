#pragma once

#include <gable/grammar/raster.h>

#include <vector>

namespace gable {

/// How wide each wall of a raster is smeared, metres: the width of the square over which heights
/// must be means to smear it so, see docs/height-field.md. Walls are told by heights alone, along
/// rows and columns, each in the direction that it crosses more steeply: level ground, a rise
/// within a few cells, a roof that is a plane beyond it. Near 0 where every height is that of one
/// surface. In no particular order.
std::vector<double> wall_widths(const HeightRaster& heights);

/// Over how wide a square every height is a mean, metres, by the middle half of the walls' widths;
/// 0 where that is less than 0.6 cells, since such heights are of single surfaces, and where fewer
/// than 50 walls are seen.
double raster_spread(std::vector<double> widths, double gsd);

}  // namespace gable
