#pragma once

#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// What tells tree crowns from roofs.
struct VegetationOptions {
  double roughness = 0.17;  ///< least deviation from any plane nearby, metres, > 0
  /// A patch of rough pixels is a crown where their mean roughness is at least this times
  /// `roughness`, >= 1; at 1 every patch is. Coarse cells need more, see `vegetation_at`.
  double least_contrast = 1.0;
  double least_height = 1.0;  ///< lower pixels are never vegetation, metres over the terrain
  double least_width = 1.4;   ///< narrower rough patches are kept: chimneys, masts, metres
  double least_area = 4.0;    ///< smaller crowns are kept: dormers, clutter, square metres
  double rim = 0.5;           ///< width of the rim that is added to crowns, metres
};

/// The options for cells of `gsd` metres. Those given are meant for 0.5 m: coarser cells take more
/// of a roof's shape into one neighbourhood, so roughness, widths and contrast grow with them.
VegetationOptions vegetation_at(const VegetationOptions& options, double gsd);

/// Marks (1) the pixels of tree crowns: those that lie in no smooth 3 x 3 neighbourhood. Each of
/// the nine neighbourhoods that hold a pixel (cells about 0.5 m apart) is fitted with a plane; on
/// roofs, also beside walls and ridges, one of them is smooth, in a crown of first returns none is.
std::vector<unsigned char> find_vegetation(const HeightImage& image,
                                           const VegetationOptions& options);

/// Sets a pixel aside of which nothing is known: it becomes bare ground of very little weight, so
/// that it decides nothing but whether blocks spread over it without need.
void set_aside(size_t pixel, HeightImage* image);

/// Sets the pixels of crowns aside; they are not the building's. Returns how many that were.
int leave_out_vegetation(const VegetationOptions& options, HeightImage* image);

}  // namespace gable
