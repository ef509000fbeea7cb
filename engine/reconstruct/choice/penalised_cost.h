#pragma once

#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>
#include <gable/residuals/robust_loss.h>

#include <array>

namespace gable {

/// What hypotheses are compared by: a minimum description length. With S the sum of squared robust
/// residuals over the N pixels that count, sigma the heights' noise, k the number of parameters:
///
///   J = S / sigma^2 + k ln N + charges
///
/// i.e. twice the negative log-likelihood under the robust loss plus the Bayesian information
/// criterion's price. Lower is better; a rule pays if it lowers J. The wings of an L or a U share
/// their eaves: they count as one parameter, and differences are charged as those of a Gaussian.
/// Low flat components, which are garages, blocks that do not fit (`count_unfit_blocks`) or are
/// shells or slivers in first returns (narrow_blocks.h), and foundations by how improbable they are
/// before the heights are looked at are charged as well.
struct PenalisedCost {
  double squared_residuals = 0.0;  ///< S, square metres
  int num_parameters = 0;          ///< k
  double prior = 0.0;              ///< the charges
  int num_samples = 0;             ///< N
  double total = 0.0;              ///< J
};

/// Scales of the penalised cost.
struct PenaltyOptions {
  double support = 0.5;  ///< metres
  LossKind loss = LossKind::kSoftL1;
  double loss_scale = 0.3;  ///< metres
  double noise = 0.15;      ///< sigma, metres, > 0
  /// Charge of each foundation, by Foundation: none unless something is known beforehand.
  std::array<double, kNumFoundationTypes> foundation_charge{};
};

/// S alone.
double squared_residuals(const HeightImage& image, const House& house,
                         const PenaltyOptions& options);

PenalisedCost penalised_cost(const HeightImage& image, const House& house,
                             const PenaltyOptions& options);

/// How many components and garages do not fit what they show: at most 75 % of their pixels lie
/// within 2.5 standard deviations. Each is charged in J.
int count_unfit_blocks(const HeightImage& image, const House& house, double noise);

/// How many parameters of a rule are charged. Those that heights hardly change from what is common
/// (a dormer's rise, a chimney's side) carry no news and are free.
int charged_parameters(const Rule& rule);

/// The part of J that depends on the derivation alone: k ln N and the prior's charge.
PenalisedCost derivation_cost(const HeightImage& image, const House& house);

/// The price of one parameter, ln N.
double parameter_price(const HeightImage& image);

}  // namespace gable
