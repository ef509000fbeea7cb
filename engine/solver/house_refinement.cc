#include <gable/engine/solver/house_problem.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/engine/stopwatch.h>
#include <gable/residuals/house_height_cost.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {

std::string check(const RefinementOptions& options) {
  if (options.stages.empty()) return "stages must not be empty";
  for (const RefinementStage& stage : options.stages) {
    if (!(stage.support > 0.0 && stage.support <= 100.0)) return "support must lie in (0, 100]";
    if (!(stage.loss_scale > 0.0 && stage.loss_scale <= 100.0)) {
      return "loss_scale must lie in (0, 100]";
    }
    if (stage.stride < 1 || stage.stride > 64) return "stride must lie in [1, 64]";
    if (stage.max_iterations < 1 || stage.max_iterations > 1000) {
      return "max_iterations must lie in [1, 1000]";
    }
  }
  if (!(options.height_deviation > 0.0 && options.height_deviation <= 100.0)) {
    return "height_deviation must lie in (0, 100]";
  }
  for (const ParameterPrior& prior : options.priors) {
    if (!(prior.deviation > 0.0)) return "a prior's deviation must be above 0";
  }
  if (!(options.function_tolerance >= 0.0 && options.function_tolerance < 1.0)) {
    return "function_tolerance must lie in [0, 1)";
  }
  return "";
}

RefinementSummary refine_house(const HeightImage& image, const RefinementOptions& options,
                               House* house) {
  CHECK(check(options).empty()) << check(options);
  CHECK(is_well_formed(*house));
  CHECK(house->origin == image.origin) << "house and image have different local frames";
  const Stopwatch watch;

  const std::vector<double*> blocks = parameter_blocks(house);
  RefinementSummary summary;
  for (size_t s = 0; s < options.stages.size(); ++s) {
    const RefinementStage& stage = options.stages[s];
    auto cost = std::make_unique<HouseHeightCost>(
        *house, &image,
        HeightCostOptions{stage.support, stage.loss, stage.loss_scale, stage.stride});
    summary.num_samples = cost->evaluator().num_samples();
    ceres::Problem::Options problem_options;
    problem_options.disable_all_safety_checks = true;
    ceres::Problem problem(problem_options);
    problem.AddResidualBlock(cost.release(), nullptr, blocks);
    if (!options.priors.empty()) {
      HouseRelation relation = parameter_priors(*house, options.priors, options.height_deviation);
      std::vector<double*> seen;
      for (int rule : relation.rules) seen.push_back(blocks[rule]);
      problem.AddResidualBlock(relation.cost.release(), nullptr, seen);
    }
    if (options.add_residuals) options.add_residuals(*house, blocks, &problem);
    set_house_bounds(image, house, &problem);
    if (!options.refine_azimuth) problem.SetParameterBlockConstant(blocks[0]);
    for (size_t b = 0; b < blocks.size() && !options.only_rules.empty(); ++b) {
      const auto& only = options.only_rules;
      if (std::find(only.begin(), only.end(), static_cast<int>(b)) == only.end()) {
        problem.SetParameterBlockConstant(blocks[b]);
      }
    }

    MinimizerOptions minimizer;
    minimizer.max_iterations = stage.max_iterations;
    minimizer.function_tolerance = options.function_tolerance;
    summary.stages.push_back(minimize(minimizer, &problem));
    summary.iterations += summary.stages.back().iterations;

    if (options.deviations && s + 1 == options.stages.size()) {
      const HouseErrors errors = house_errors(image, *house);
      summary.mad = errors.mad;
      summary.rmse = errors.rmse;
      summary.deviations = house_deviations(errors.noise, house, &problem);
    }
  }
  if (!options.deviations) {
    const HouseErrors errors = house_errors(image, *house);
    summary.mad = errors.mad;
    summary.rmse = errors.rmse;
  }
  summary.final_cost = summary.stages.back().final_cost;
  summary.termination = summary.stages.back().termination;
  summary.time_ms = watch.ms();
  return summary;
}

}  // namespace gable
