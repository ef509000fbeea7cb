#pragma once

#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// How many components of a house show themselves as strips only: of the pixels that see them from
/// above, dormers and chimneys taken away, at most half lie in a square of 3 x 3 that all see the
/// component. Of what is narrower a raster has no pixel that is not smeared by its borders, and a
/// shell around a block, one pixel wide, copies a smeared wall better than any wall does. A house
/// of one component has none.
int count_narrow_blocks(const HeightImage& image, const House& house);

}  // namespace gable
