#pragma once

#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gable/grammar/house.h>

#include <vector>

namespace gable {

/// How first values of foundations are searched.
struct BlockSearchOptions {
  double loss_scale = 0.3;   ///< soft L1 scale, metres, > 0
  int per_foundation = 2;    ///< hypotheses kept of each foundation type, [1, 10]
  int max_rectangles = 500;  ///< rectangles that enter pairs and triples, [1, 1000]
};

/// A house with first values, and how well its cells fit before any refinement.
struct Hypothesis {
  House house;
  double gain = 0.0;  ///< squared metres of robust cost saved against bare ground; larger is better
};

/// First values of every foundation type without learning. Rectangles between edge lines get their
/// best roofs; sets of one, two and three of them are compared by the heights of their upper
/// envelope (not by the mask alone, so that blocks of equal depth and different heights are told
/// apart); pairs that share an outer corner are L, a base with two wings U.
///
/// Returns at most `per_foundation` hypotheses per type, best first within each type, differing by
/// more than a shift of an edge line. Houses have the image's origin and the view's azimuth.
std::vector<Hypothesis> search_blocks(const RectifiedView& view, const Eigen::Vector3d& origin,
                                      const BlockSearchOptions& options);

}  // namespace gable
