#pragma once

#include <ceres/cost_function.h>
#include <gable/grammar/house.h>

#include <memory>
#include <vector>

namespace gable {

/// A residual over the rules of a house: the cost function and, in the order of its parameter
/// blocks, the positions of these rules in House::derivation().
struct HouseRelation {
  std::unique_ptr<ceres::CostFunction> cost;
  std::vector<int> rules;
};

// Weights: residuals are weight times a difference of parameters, in their unit. To weigh them
// against heights in metres, a weight is sigma_height / sigma_difference.

/// One parameter of one rule equals one of another rule or of the same one: one residual,
/// weight * (rule_a[index_a] - rule_b[index_b]).
HouseRelation equal_parameters(const House& house, int rule_a, int index_a, int rule_b, int index_b,
                               double weight);

/// Two components have their eaves at one height: weight * (eaves_a - eaves_b), metres.
HouseRelation equal_eaves(const House& house, int component_a, int component_b, double weight);

/// Two components have their ridges at one height: weight * (eaves_a + rise_a - eaves_b - rise_b),
/// metres. A flat roof's ridge is its eaves.
HouseRelation equal_ridges(const House& house, int component_a, int component_b, double weight);

/// A hip roof has the same ratio at both ends: weight * (hip_start - hip_end), ratio.
HouseRelation symmetric_hips(const House& house, int component, double weight);

/// Two dormers of one component look alike: weight * the differences of width, depth, eaves and
/// rise, and of the centres across the parent's ridge (they stand in one row). Five residuals,
/// metres.
HouseRelation alike_dormers(const House& house, int dormer_a, int dormer_b, double weight);

/// What is known of one parameter of a rule besides the heights.
struct ParameterPrior {
  int rule = 0;            ///< position in House::derivation()
  int parameter = 0;       ///< position in Rule::values
  double mean = 0.0;       ///< in the parameter's unit
  double deviation = 1.0;  ///< standard deviation, same unit, > 0
};

/// Gaussian priors: for each, weight * (value - mean) / deviation, in the order given. weight 1
/// counts in standard deviations; the standard deviation of one height (metres) makes the priors
/// comparable with height residuals in metres. Azimuths are compared as numbers, so a mean must be
/// given on the branch of the current value.
HouseRelation parameter_priors(const House& house, const std::vector<ParameterPrior>& priors,
                               double weight);

}  // namespace gable
