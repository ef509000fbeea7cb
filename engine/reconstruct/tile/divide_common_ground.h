#pragma once

#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <vector>

namespace gable {

/// Takes from houses that were found in the heights what they take of each other: ground that two
/// of them cover is divided (neighbours/divided_ground.h), and they get known walls, where these
/// leave valid solids of one piece; their fit and solids are made anew. What differs by less than
/// half a square metre is left alone, and so are houses whose walls are known already. The result
/// does not depend on the number of threads.
void divide_common_ground(int threads, std::vector<TileBuilding>* window);

}  // namespace gable
