#include <gable/engine/reconstruct/choice/narrow_blocks.h>
#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>

#include <cmath>

namespace gable {
namespace {

// Standard deviation of the eaves of one polygon's wings, metres.
constexpr double kSharedEavesDeviation = 0.2;

// A flat block lower than this, metres, is a garage; as a component it is charged.
constexpr double kGarageHeight = 3.8;
constexpr double kLowFlatCharge = 15.0;

// A component or garage fits if this share of what it shows lies within so many standard deviations
// of it. One that does not is a crown or another misunderstanding and costs this much.
constexpr double kFittingShare = 0.75;
constexpr double kFittingDeviations = 2.5;
constexpr double kUnfitCharge = 80.0;

// What a shell around a component or a sliver in one costs (narrow_blocks.h).
constexpr double kNarrowCharge = 80.0;

// Pixels that count: those of the building. Empty ground around it says nothing about how many
// parameters a house deserves, and would make the price depend on the crop's margin.
int count_inside(const HeightImage& image) {
  int n = 0;
  for (size_t i = 0; i < image.size(); ++i) n += image.inside[i] && is_evidence(image, i);
  return n;
}

}  // namespace

double parameter_price(const HeightImage& image) {
  return std::log(std::max(3, count_inside(image)));
}

int count_unfit_blocks(const HeightImage& image, const House& house, double noise) {
  const HeightField field(house);
  std::vector<int> seen(field.blocks().size(), 0), near(field.blocks().size(), 0);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      const Layers<double> layers = layers_at<double, double>(field.blocks(), p.x(), p.y(), 0.0);
      if (layers.count == 0) continue;
      const int b = layers.layers[0].block;
      ++seen[b];
      const double expected = image.spread > 0.0 ? field.at_house(p, image.spread, image.ground[i])
                                                 : layers.layers[0].height;
      near[b] += std::abs(expected - image.height[i]) < kFittingDeviations * noise;
    }
  }
  int unfit = 0;
  for (size_t b = 0; b < seen.size(); ++b) {
    unfit += !stands_on_roof(field.sources()[b].role) && near[b] <= kFittingShare * seen[b];
  }
  return unfit;
}

int charged_parameters(const Rule& rule) {
  if (rule.kind == RuleKind::kDormer) return rule.size() - 1;
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
    // The eaves are shared, and a hip at a corner follows from the pitch: one end of every wing,
    // both of a U's base.
    cost.num_parameters -= house.num_components() - 1;
    for (int i = 0; i < house.num_components(); ++i) {
      if (house.roofs[i].kind != RuleKind::kRoofHip) continue;
      cost.num_parameters -= house.foundation == Foundation::kU && i == 0 ? 2 : 1;
    }
  }
  if (house.num_components() > 1) {
    for (const Rule& roof : house.roofs) {
      if (roof.kind == RuleKind::kRoofFlat && roof[param::roof::kEaves] < kGarageHeight) {
        cost.prior += kLowFlatCharge;
      }
    }
  }
  cost.total = cost.num_parameters * parameter_price(image) + cost.prior;
  return cost;
}

double squared_residuals(const HeightImage& image, const House& house,
                         const PenaltyOptions& options) {
  const HouseHeightEvaluator evaluator(
      house, &image, HeightCostOptions{options.support, options.loss, options.loss_scale, 1});
  std::vector<const double*> parameters;
  for (const Rule* rule : house.derivation()) parameters.push_back(rule->values.data());
  return evaluator.squared_residuals(parameters.data());
}

PenalisedCost penalised_cost(const HeightImage& image, const House& house,
                             const PenaltyOptions& options) {
  PenalisedCost cost = derivation_cost(image, house);
  cost.squared_residuals = squared_residuals(image, house, options);
  // Smear is no reason for a shell where means are compared with means, and what is narrow for cells
  // that are coarse enough to be smeared may be a bay.
  const int narrow = image.spread > 0.0 ? 0 : count_narrow_blocks(image, house);
  const double charge = kUnfitCharge * count_unfit_blocks(image, house, options.noise) +
                        kNarrowCharge * narrow +
                        options.foundation_charge[static_cast<size_t>(house.foundation)];
  cost.prior += charge;
  cost.total += charge + cost.squared_residuals / (options.noise * options.noise);
  return cost;
}

}  // namespace gable
