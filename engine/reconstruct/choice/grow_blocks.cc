#include <gable/engine/reconstruct/choice/block_proposals.h>
#include <gable/engine/reconstruct/choice/derivation_rewrites.h>
#include <gable/engine/reconstruct/choice/grow_blocks.h>
#include <gable/engine/reconstruct/choice/leftovers.h>
#include <gable/engine/reconstruct/choice/roof_simplification.h>
#include <gable/engine/reconstruct/heights/rectified_view.h>
#include <gable/engine/solver/house_refinement.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

struct Grown {
  House house;
  PenalisedCost cost;
};

// The house with other components and its details where they were.
House with_blocks(const House& house, const std::vector<RoofedRectangle>& blocks) {
  House out = blocks_house(blocks, house.azimuth[0]);
  out.origin = house.origin;
  out.dormers = house.dormers;
  out.chimneys = house.chimneys;
  out.garages = house.garages;
  reassign_dormers(&out);
  return out;
}

RectifiedView view_of(const HeightImage& image, double azimuth) {
  const auto inside = std::count(image.inside.begin(), image.inside.end(), 1);
  // Of large buildings some 80 cells a side are enough for first values.
  const double side = std::sqrt(static_cast<double>(inside)) * image.gsd;
  return rectify(image, azimuth, std::max({image.gsd, 0.5, side / 80.0}), 1.5);
}

RefinementOptions short_refinement(std::vector<RefinementStage> stages) {
  RefinementOptions refinement;
  refinement.function_tolerance = 1e-3;
  refinement.deviations = false;
  refinement.stages = std::move(stages);
  return refinement;
}

// Drops components that do not pay once the others are refined without them: what a first value
// got wrong may be covered by those that came later.
void drop_blocks(const HeightImage& image, const GrowthOptions& options, Grown* grown) {
  const PenaltyOptions& penalty = options.penalty;
  const RefinementOptions refinement =
      short_refinement({{0.5, LossKind::kGemanMcClure, 0.5, 1, 8},
                        {penalty.support, penalty.loss, penalty.loss_scale, 1, 4}});
  for (int i = grown->house.num_components() - 1; i >= 0; --i) {
    if (grown->house.num_components() < 2) return;
    std::vector<RoofedRectangle> blocks = roofed_rectangles(grown->house);
    blocks.erase(blocks.begin() + i);
    House without = with_blocks(grown->house, blocks);
    refine_house(image, refinement, &without);
    const PenalisedCost cost = penalised_cost(image, without, penalty);
    if (cost.total < grown->cost.total) *grown = {without, cost};
  }
}

Grown refined(const HeightImage& image, const GrowthOptions& options, const House& house,
              const BlockProposal& proposal) {
  Grown grown{with_blocks(house, proposal.blocks), {}};
  // A loss that does not saturate bends a new block towards what belongs to its neighbours.
  RefinementOptions refinement = short_refinement(
      {{1.0, LossKind::kSoftL1, 0.3, 1, 10}, {0.5, LossKind::kGemanMcClure, 0.5, 1, 8}});
  for (int block : proposal.changed) {
    refinement.only_rules.push_back(grown.house.footprint_block(block));
    refinement.only_rules.push_back(grown.house.roof_block(block));
  }
  refine_house(image, refinement, &grown.house);
  const PenaltyOptions& penalty = options.penalty;
  refinement.only_rules.clear();
  refinement.stages = {{0.5, LossKind::kGemanMcClure, 0.5, 1, 8},
                       {penalty.support, penalty.loss, penalty.loss_scale, 1, 8}};
  refine_house(image, refinement, &grown.house);
  drop_unpaid(image, options.detail_penalty, &grown.house);
  simplify_roofs(image, penalty, &grown.house);
  grown.cost = penalised_cost(image, grown.house, penalty);
  return grown;
}

}  // namespace

std::string check(const GrowthOptions& options) {
  if (options.most_blocks < 1 || options.most_blocks > 20) return "most_blocks must lie in [1, 20]";
  if (options.tries < 1 || options.tries > 20) return "tries must lie in [1, 20]";
  if (!(options.least_residual > 0.0)) return "least_residual must be positive";
  if (!(options.least_area > 0.0)) return "least_area must be positive";
  return "";
}

bool grow_blocks(const HeightImage& image, const GrowthOptions& options, House* house,
                 PenalisedCost* cost) {
  CHECK(check(options).empty()) << check(options);
  CHECK(is_well_formed(*house));
  BlockProposalOptions proposing;
  proposing.least_residual = options.least_residual;
  proposing.least_area = options.least_area;
  proposing.loss = options.penalty.loss;
  proposing.loss_scale = options.penalty.loss_scale;
  proposing.most_blocks = options.most_blocks;

  Grown now{*house, *cost};
  // Every round either adds a block or cuts one to size.
  for (int round = 0; round < 2 * options.most_blocks; ++round) {
    const RectifiedView view = view_of(image, now.house.azimuth[0]);
    // In the view's cells, which may be larger than pixels.
    proposing.parameter_price = parameter_price(image) * options.penalty.noise *
                                options.penalty.noise * (image.gsd * image.gsd) /
                                (view.cell * view.cell);
    std::vector<BlockProposal> proposals = propose_blocks(view, now.house, proposing);
    if (static_cast<int>(proposals.size()) > options.tries) proposals.resize(options.tries);
    Grown best = now;
    for (const BlockProposal& proposal : proposals) {
      Grown grown = refined(image, options, now.house, proposal);
      if (grown.cost.total < best.cost.total) best = std::move(grown);
    }
    if (!(best.cost.total < now.cost.total)) break;
    now = std::move(best);
  }
  if (!(now.cost.total < cost->total)) return false;
  drop_blocks(image, options, &now);
  *house = std::move(now.house);
  *cost = now.cost;
  return true;
}

}  // namespace gable
