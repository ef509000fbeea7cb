#pragma once

#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gable/grammar/house.h>
#include <gable/grammar/wing_polygons.h>
#include <gable/residuals/robust_loss.h>

#include <vector>

namespace gable {

/// Where a house is said to lack a block.
struct BlockProposalOptions {
  double least_residual = 0.3;  ///< of a cell to count as unexplained, metres, > 0
  double least_area = 4.0;      ///< of cells that hang together, square metres, > 0
  LossKind loss = LossKind::kSoftL1;
  double loss_scale = 0.3;        ///< metres, > 0
  double parameter_price = 0.15;  ///< of one parameter in robust cost, square metres, >= 0
  int most_blocks = 8;            ///< no proposal has more, >= 1
};

/// Components that a house might have instead of its own.
struct BlockProposal {
  std::vector<RoofedRectangle> blocks;  ///< all of them, old ones first and in their order
  std::vector<int> changed;             ///< numbers of those that are new or not as they were
  double gain = 0.0;  ///< robust cost saved over the view less the price, square metres
};

/// Proposes changes where connected cells of one sign leave more unexplained than a block costs:
///
/// - *addition*: where heights stand above the house, on it or beside it, a block over the region,
///   or over two such regions that are the arms of one block across the house;
/// - *split*: where a component leaves much unexplained (it stands over what is lower, or ridges
///   step), it is cut in two at the line along either axis that explains most. Each part gets a
///   roof of its own, or is given up.
///
/// Roofs come from `fit_roof` over the cells that the rest of the house leaves. `view` is turned by
/// the house's azimuth. Returns those that save something before any refinement, best first; none
/// where all that is unexplained is small.
std::vector<BlockProposal> propose_blocks(const RectifiedView& view, const House& house,
                                          const BlockProposalOptions& options);

}  // namespace gable
