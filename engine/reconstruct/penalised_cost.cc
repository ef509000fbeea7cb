#include <gable/engine/reconstruct/penalised_cost.h>
#include <gable/residuals/house_height_cost.h>

#include <cmath>

namespace gable {
namespace {

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

PenalisedCost penalised_cost(const HeightImage& image, const House& house,
                             const PenaltyOptions& options) {
  const HouseHeightEvaluator evaluator(
      house, &image, HeightCostOptions{options.support, options.loss, options.loss_scale, 1});
  std::vector<const double*> parameters;
  for (const Rule* rule : house.derivation()) parameters.push_back(rule->values.data());
  PenalisedCost cost;
  cost.squared_residuals = evaluator.squared_residuals(parameters.data());
  cost.num_parameters = evaluator.num_parameters();
  cost.num_samples = count_inside(image);
  cost.total = cost.squared_residuals / (options.noise * options.noise) +
               cost.num_parameters * parameter_price(image);
  return cost;
}

}  // namespace gable
