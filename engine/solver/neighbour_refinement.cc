#include <ceres/loss_function.h>
#include <gable/engine/solver/house_problem.h>
#include <gable/engine/solver/neighbour_refinement.h>
#include <gable/residuals/house_height_cost.h>
#include <glog/logging.h>

#include <memory>

namespace gable {
namespace {

std::unique_ptr<HouseHeightCost> height_cost(const HeightImage& image, const RefinementStage& stage,
                                             const House& house) {
  return std::make_unique<HouseHeightCost>(
      house, &image, HeightCostOptions{stage.support, stage.loss, stage.loss_scale, stage.stride});
}

ceres::Problem::Options problem_options() {
  ceres::Problem::Options options;
  options.disable_all_safety_checks = true;
  return options;
}

}  // namespace

std::string check(const NeighbourRefinementOptions& options) {
  RefinementOptions single;
  single.stages = {options.stage};
  single.height_deviation = options.height_deviation;
  single.function_tolerance = options.function_tolerance;
  if (const std::string error = check(single); !error.empty()) return error;
  return check(options.relations);
}

NeighbourRefinementSummary refine_neighbours(const std::vector<NeighbourHouse>& houses,
                                             const std::vector<NeighbourRelation>& relations,
                                             const NeighbourRefinementOptions& options) {
  CHECK(check(options).empty()) << check(options);
  NeighbourRefinementSummary summary;
  ceres::Problem problem(problem_options());
  std::vector<const House*> views;
  std::vector<std::vector<double*>> blocks;
  for (const auto& [image, house] : houses) {
    CHECK(is_well_formed(*house));
    CHECK(house->origin == image->origin) << "house and image have different local frames";
    views.push_back(house);
    blocks.push_back(parameter_blocks(house));
    problem.AddResidualBlock(height_cost(*image, options.stage, *house).release(), nullptr,
                             blocks.back());
    set_house_bounds(*image, house, &problem);
    summary.num_parameters += house->num_parameters();
  }
  for (const NeighbourRelation& relation : relations) {
    const RelationScale& scale = scale_of(options.relations, relation.kind);
    const double weight = options.height_deviation / scale.deviation;
    HousePairRelation residual = residual_of(views, relation, weight);
    std::vector<double*> seen;
    for (int rule : residual.rules_a) seen.push_back(blocks[relation.house_a][rule]);
    for (int rule : residual.rules_b) seen.push_back(blocks[relation.house_b][rule]);
    problem.AddResidualBlock(residual.cost.release(), new ceres::CauchyLoss(weight * scale.let_go),
                             seen);
  }
  MinimizerOptions minimizer;
  minimizer.max_iterations = options.stage.max_iterations;
  minimizer.function_tolerance = options.function_tolerance;
  minimizer.sparse = options.sparse;
  summary.minimizer = minimize(minimizer, &problem);
  for (const NeighbourRelation& relation : relations) {
    summary.misfits.push_back(misfit(views, relation));
  }
  return summary;
}

std::vector<std::vector<double>> deviations_from_heights(const HeightImage& image,
                                                         const RefinementStage& stage,
                                                         const House& house) {
  House copy = house;
  ceres::Problem problem(problem_options());
  problem.AddResidualBlock(height_cost(image, stage, copy).release(), nullptr,
                           parameter_blocks(&copy));
  return house_deviations(house_errors(image, copy).noise, &copy, &problem);
}

}  // namespace gable
