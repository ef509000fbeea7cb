#pragma once

#include <gable/engine/reconstruct/first_values/first_values.h>
#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gable/engine/reconstruct/first_values/plane_blocks.h>
#include <gable/residuals/height_image.h>

#include <string>
#include <vector>

namespace gable {

/// How houses are made of a building's planes.
struct ScaleValuesOptions {
  PlaneBlockOptions blocks;
  double least_share = 0.06;  ///< of a block's pixels in those of all, to be one, [0, 1]
  double same_corner = 1.5;   ///< outer corners of wings that lie as near are one, metres, > 0
  int most_houses = 4;        ///< [1, 10]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ScaleValuesOptions& options);

/// First values from the planes at a building's structural scales: the azimuth from the directions
/// in which the planes of the roofs fall (where all are level, that of the outline), blocks
/// (plane_blocks.h), and of these an I of the largest, a II and a III of the largest two and three,
/// and an L or a U where two or three share outer corners. Where the planes
/// make no block those of the coarsest scale are taken for flat roofs. Houses have the
/// image's origin; none where there are no planes.
std::vector<FirstValue> scale_values(const HeightImage& image, const HouseScales& scales,
                                     const ScaleValuesOptions& options = {});

}  // namespace gable
