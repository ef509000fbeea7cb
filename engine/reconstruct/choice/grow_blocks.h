#pragma once

#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <string>

namespace gable {

/// How a house gets more blocks than its first values have.
struct GrowthOptions {
  PenaltyOptions penalty;         ///< decides
  PenaltyOptions detail_penalty;  ///< prices what dormers, chimneys and garages are left for
  int most_blocks = 8;            ///< components, [1, 20]
  int tries = 3;                  ///< proposals that are refined in each round, [1, 20]
  double least_residual = 0.3;    ///< of a cell to count as unexplained, metres, > 0
  double least_area = 4.0;        ///< of unexplained cells that hang together, square metres, > 0
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const GrowthOptions& options);

/// Adds blocks to a refined house while the penalised cost pays for them, so that crosses, Zs, rows
/// that step and the like are derivations: I, II, III and N. Each round takes the best proposals of
/// `propose_blocks`, refines each, its own blocks first and then all together, and keeps the one of
/// least J if that is less than before; in the end blocks that no longer pay are dropped. An L or U
/// is seen as its II or III. The house and `cost` are changed only if J ends below that of the
/// house given. Returns whether it does.
bool grow_blocks(const HeightImage& image, const GrowthOptions& options, House* house,
                 PenalisedCost* cost);

}  // namespace gable
