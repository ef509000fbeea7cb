#pragma once

#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// How many components of a house are shells around another or slivers in another: one of the two
/// lies within the other for 70 % of its plan, and of the pixels that see the component from above,
/// dormers and chimneys taken away, at most half lie in a square of 3 x 3 that all see it. Of what
/// is narrower a raster has no pixel that is not smeared by its borders, and a shell around a
/// block, one pixel wide, copies a smeared wall better than any wall does.
int count_narrow_blocks(const HeightImage& image, const House& house);

}  // namespace gable
