#pragma once

#include <gable/engine/solver/house_refinement.h>
#include <gable/engine/solver/minimizer.h>
#include <gable/engine/solver/neighbour_relations.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <string>
#include <vector>

namespace gable {

/// A house with the heights of its own crop; house->origin must equal image->origin.
struct NeighbourHouse {
  const HeightImage* image = nullptr;
  House* house = nullptr;
};

/// How houses are refined together.
struct NeighbourRefinementOptions {
  /// How houses are compared with their heights; that of the last stage they were refined in.
  RefinementStage stage = {0.25, LossKind::kGemanMcClure, 0.5, 1, 20};
  NeighbourRelationOptions relations;
  /// Standard deviation of one pixel's height, metres, (0, 100]: what relations are weighed against
  /// pixels by.
  double height_deviation = 0.2;
  double function_tolerance = 1e-5;  ///< relative change of the cost that ends it, [0, 1)
  bool sparse = true;                ///< sparse elimination (SuiteSparse) instead of dense
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const NeighbourRefinementOptions& options);

/// What a joint refinement did.
struct NeighbourRefinementSummary {
  MinimizerSummary minimizer;
  int num_parameters = 0;
  std::vector<double> misfits;  ///< of the relations, in their order, afterwards; see `misfit`
};

/// Refines all parameters of several houses in place as one problem: each house against its own
/// heights (HouseHeightCost, within the bounds of its tables), and between them `relations`, whose
/// house numbers are positions in `houses`. With sigma the heights' deviation, a relation of misfit
/// d adds
///
///   1/2 (sigma let_go / deviation)^2 log(1 + |d|^2 / let_go^2)
///
/// which near 0 is 1/2 (sigma |d| / deviation)^2, a pixel off by sigma for each deviation, and
/// which beyond let_go pulls less the further it is: where the heights disagree, it lets go. A
/// house's heights touch its own blocks and a relation those of two houses, so the normal equations
/// are sparse and time grows linearly along a row. One thread; the same bytes on every run.
NeighbourRefinementSummary refine_neighbours(const std::vector<NeighbourHouse>& houses,
                                             const std::vector<NeighbourRelation>& relations,
                                             const NeighbourRefinementOptions& options);

/// Standard deviations of a house's parameters given its own heights alone, at its current values,
/// one vector per rule in derivation order; what neighbours add is not in them.
std::vector<std::vector<double>> deviations_from_heights(const HeightImage& image,
                                                         const RefinementStage& stage,
                                                         const House& house);

}  // namespace gable
