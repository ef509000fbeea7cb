#pragma once

#include <gable/engine/solver/minimizer.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>
#include <gable/residuals/house_relations.h>
#include <gable/residuals/robust_loss.h>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gable {

/// One stage of the annealed refinement.
struct RefinementStage {
  double support = 0.5;  ///< width of the samples' support, metres, (0, 100]
  LossKind loss = LossKind::kSoftL1;
  double loss_scale = 0.3;  ///< metres, (0, 100]
  int stride = 1;           ///< use every stride-th pixel of every stride-th row, [1, 64]
  int max_iterations = 20;  ///< [1, 1000]
};

/// Adds residuals of one's own to the problem of a stage. `blocks` are the parameter blocks in the
/// order of House::derivation(), which `house` gives the kinds and positions of; the values are
/// read and written through `blocks`. The problem takes ownership of the cost functions. Called
/// once per stage, from the thread that refines.
using AddResiduals = std::function<void(const House& house, std::span<double* const> blocks,
                                        ceres::Problem* problem)>;

/// How a house is refined against a height image (NPR section 4.5).
struct RefinementOptions {
  /// Stages in order. A wide support pulls edges from far away and a loss that never saturates
  /// pulls heights from far away; a narrow support places edges exactly, and a saturating loss does
  /// not listen to trees.
  std::vector<RefinementStage> stages = {{1.5, LossKind::kSoftL1, 0.3, 1, 30},
                                         {0.5, LossKind::kGemanMcClure, 0.5, 1, 20},
                                         {0.25, LossKind::kGemanMcClure, 0.5, 1, 20}};
  double function_tolerance = 1e-5;  ///< relative change of the cost that ends a stage, [0, 1)
  bool refine_azimuth = true;
  /// Positions (House::derivation) of the rules to refine; the others stay. Empty: all.
  std::vector<int> only_rules;
  /// What is known of parameters besides the heights (detectors, planes), weighed against pixels by
  /// `height_deviation`, the standard deviation of one pixel's height, metres, (0, 100].
  std::vector<ParameterPrior> priors;
  double height_deviation = 0.2;
  /// What else is known, as residuals of one's own; empty: nothing. One that is a difference in
  /// metres of standard deviation d is weighed against pixels by `height_deviation` / d.
  AddResiduals add_residuals;
  bool deviations = true;  ///< compute the parameters' standard deviations at the end
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RefinementOptions& options);

/// What a refinement did.
struct RefinementSummary {
  std::vector<MinimizerSummary> stages;
  double final_cost = -1.0;  ///< half the sum of squared residuals in the last stage, priors and
                             ///< own residuals included
  int num_samples = 0;       ///< pixels compared in the last stage
  int iterations = 0;        ///< over all stages
  double time_ms = 0.0;
  Termination termination = Termination::kFailed;  ///< of the last stage
  /// Mean |h - height| over the pixels the house covers, metres: point samples, or means over the
  /// image's spread.
  double mad = 0.0;
  double rmse = 0.0;  ///< root mean square over the same pixels, metres
  /// Standard deviations per rule in derivation order; empty if not asked for.
  std::vector<std::vector<double>> deviations;
};

/// Refines all parameters of `house` in place against `image`, each rule one parameter block with
/// the bounds of its table. house->origin must equal image.origin (the local frames agree).
RefinementSummary refine_house(const HeightImage& image, const RefinementOptions& options,
                               House* house);

}  // namespace gable
