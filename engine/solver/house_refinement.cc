#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>
#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Highest measurement of an image, metres above its origin.
double highest(const HeightImage& image) {
  double top = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < image.size(); ++i) {
    if (is_evidence(image, i)) top = std::max(top, static_cast<double>(image.height[i]));
  }
  return top;
}

// Nothing stands far above the highest measurement; a block over pixels that a saturating loss has
// given up would rise without end otherwise.
constexpr double kHeadroom = 2.0;

bool is_height(const ParameterSpec& spec) { return spec.name == "eaves" || spec.name == "height"; }

void set_bounds(const Rule& rule, double top, double* block, ceres::Problem* problem) {
  std::vector<ParameterSpec> specs(parameter_specs(rule.kind).begin(),
                                   parameter_specs(rule.kind).end());
  for (size_t k = 0; k < specs.size(); ++k) {
    if (is_height(specs[k])) {
      specs[k].upper = std::clamp(top + kHeadroom, specs[k].lower + 1.0, specs[k].upper);
    }
    // A start outside its bounds is projected: Ceres refuses infeasible starts.
    block[k] = std::clamp(block[k], specs[k].lower, specs[k].upper);
    if (std::isfinite(specs[k].lower)) {
      problem->SetParameterLowerBound(block, static_cast<int>(k), specs[k].lower);
    }
    if (std::isfinite(specs[k].upper)) {
      problem->SetParameterUpperBound(block, static_cast<int>(k), specs[k].upper);
    }
  }
}

struct PointErrors {
  double mad = 0.0;
  double rmse = 0.0;
  double noise = 0.0;  ///< robust standard deviation over the covered pixels
};

PointErrors point_errors(const HeightImage& image, const House& house) {
  const HeightField field(house);
  std::vector<double> errors;
  double sum = 0.0, squares = 0.0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      if (field.block_at_house(p) < 0) continue;
      const double error = std::abs(field.at_house(p, 0.0, image.ground[i]) - image.height[i]);
      errors.push_back(error);
      sum += error;
      squares += error * error;
    }
  }
  PointErrors out;
  if (errors.empty()) return out;
  const double n = static_cast<double>(errors.size());
  out.mad = sum / n;
  out.rmse = std::sqrt(squares / n);
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  out.noise = 1.4826 * errors[errors.size() / 2];
  return out;
}

}  // namespace

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
  const auto start = std::chrono::steady_clock::now();

  const std::vector<Rule*> rules = house->derivation();
  std::vector<double*> blocks;
  for (Rule* rule : rules) blocks.push_back(rule->values.data());

  const double top = highest(image);
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
    for (size_t b = 0; b < rules.size(); ++b) set_bounds(*rules[b], top, blocks[b], &problem);
    if (!options.refine_azimuth) problem.SetParameterBlockConstant(blocks[0]);
    for (size_t b = 0; b < rules.size() && !options.only_rules.empty(); ++b) {
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
      const PointErrors errors = point_errors(image, *house);
      summary.mad = errors.mad;
      summary.rmse = errors.rmse;
      const double variance = errors.noise * errors.noise;
      const std::vector<double> all = parameter_deviations(blocks, variance, &problem);
      size_t next = 0;
      for (const Rule* rule : rules) {
        const size_t size = rule->parameters().size();
        summary.deviations.emplace_back(all.begin() + next, all.begin() + next + size);
        next += size;
      }
    }
  }
  if (!options.deviations) {
    const PointErrors errors = point_errors(image, *house);
    summary.mad = errors.mad;
    summary.rmse = errors.rmse;
  }
  summary.final_cost = summary.stages.back().final_cost;
  summary.termination = summary.stages.back().termination;
  summary.time_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return summary;
}

}  // namespace gable
