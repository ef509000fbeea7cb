#include <gable/engine/reconstruct/penalised_cost.h>
#include <gable/residuals/house_height_cost.h>

#include <cmath>

namespace gable {
namespace {

// Standard deviation of the eaves of one polygon's wings, metres.
constexpr double kSharedEavesDeviation = 0.2;

// Pixels that count: those of the building. Empty ground around it says nothing about how many
// parameters a house deserves, and would make the price depend on the crop's margin.
int count_inside(const HeightImage& image) {
  int n = 0;
  for (size_t i = 0; i < image.size(); ++i) n += image.inside[i] && image.weight[i] > 0.0f;
  return n;
}

}  // namespace

double parameter_price(const HeightImage& image) {
  return std::log(std::max(3, count_inside(image)));
}

int charged_parameters(const Rule& rule) {
  if (rule.kind == RuleKind::kDormer) return rule.size() - 2;
  if (rule.kind == RuleKind::kChimney) return rule.size() - 1;
  return rule.size();
}

PenalisedCost derivation_cost(const HeightImage& image, const House& house) {
  PenalisedCost cost;
  for (const Rule* rule : house.derivation()) cost.num_parameters += charged_parameters(*rule);
  cost.num_samples = count_inside(image);
  if (house.foundation == Foundation::kL || house.foundation == Foundation::kU) {
    double mean = 0.0;
    for (const Rule& roof : house.roofs) mean += roof[param::roof::kEaves];
    mean /= house.num_components();
    for (const Rule& roof : house.roofs) {
      const double z = (roof[param::roof::kEaves] - mean) / kSharedEavesDeviation;
      cost.prior += z * z;
    }
    cost.num_parameters -= house.num_components() - 1;
  }
  cost.total = cost.num_parameters * parameter_price(image) + cost.prior;
  return cost;
}

PenalisedCost penalised_cost(const HeightImage& image, const House& house,
                             const PenaltyOptions& options) {
  const HouseHeightEvaluator evaluator(
      house, &image, HeightCostOptions{options.support, options.loss, options.loss_scale, 1});
  std::vector<const double*> parameters;
  for (const Rule* rule : house.derivation()) parameters.push_back(rule->values.data());
  PenalisedCost cost = derivation_cost(image, house);
  cost.squared_residuals = evaluator.squared_residuals(parameters.data());
  cost.total += cost.squared_residuals / (options.noise * options.noise);
  return cost;
}

}  // namespace gable
