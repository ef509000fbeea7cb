#pragma once

#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// What the refinement benchmarks fit: a hipped and a gabled I block that overlap, seen as a
/// 64 x 64 crop at 0.5 m with the noise of NPR section 5.1 (uniform within 0.3 m on 70 % of the
/// pixels), a tree beside the wall and 3 % outliers; and a start that is off by about 1 m in plan,
/// 10 % in size, 0.5 m in height and 3 degrees.
struct TwoBlockScene {
  House truth;
  House start;
  HeightImage image;
};

TwoBlockScene make_two_block_scene();

}  // namespace gable
