#pragma once

#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>
#include <gable/residuals/robust_loss.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A roof's profile across its ridge: straight from the eaves to a break, and straight from there
/// to the ridge. Runs are shares of the half width.
struct BrokenProfile {
  double eaves = 0.0;       ///< metres
  double lower_rise = 0.0;  ///< from the eaves to the break, metres
  double upper_rise = 0.0;  ///< from the break to the ridge, metres
  double break_run = 0.0;   ///< in (0, 0.5]
  double saved = 0.0;       ///< robust cost below that of the best unbroken profile, square metres
};

/// The broken profile that is nearest to `samples` (x: distance from the eaves as a share of the
/// half width, in [0, 1]; y: height, metres) under the loss, among breaks at 0.1 to 0.5 in steps of
/// 0.05, by reweighted regression. None where there are fewer than twelve samples.
std::optional<BrokenProfile> fit_broken_profile(const std::vector<Eigen::Vector2d>& samples,
                                                const RobustLoss& loss);

/// Makes mansards of gables and hips where the penalised cost says so. Fitting one costs a
/// refinement, so it is tried only where the heights over a component bend like a mansard: the best
/// broken profile, whose lower part is steep (45 degrees) and twice as steep as its upper part,
/// saves more than its two parameters cost. Returns how many roofs changed; where any did, the
/// whole house has been refined.
int make_mansards(const HeightImage& image, const PenaltyOptions& penalty, House* house);

}  // namespace gable
