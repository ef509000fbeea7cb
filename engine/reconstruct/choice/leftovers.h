#pragma once

#include <gable/engine/reconstruct/choice/penalised_cost.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// When what a house leaves unexplained becomes a rule.
struct LeftoverOptions {
  PenaltyOptions penalty;           ///< prices rules
  double least_height = 0.3;        ///< of a pixel above the model to count, metres, > 0;
                                    ///< 2.5 times the noise where that is more
  double least_garage_area = 4.0;   ///< square metres, > 0
  double most_roof_area = 30.0;     ///< of a dormer or chimney proposal, square metres
  double least_chimney_rise = 0.7;  ///< over the roof at its centre, metres
  double most_chimney_rise = 3.5;   ///< metres
  double most_dormer_rise = 1.8;    ///< of its ridge over the roof at its centre, metres
  double least_dormer_area = 2.2;   ///< of its rectangle, square metres
  double fitting_share = 0.6;       ///< of a garage's pixels within 0.5 m of its top, [0, 1]
};

/// Adds dormers, chimneys and garages to `house` where connected pixels stand above it: each region
/// on the roof is fitted as a dormer and as a chimney, each region beside it as a garage (a flat
/// rectangle), alone against its surroundings; a rule stays if it lowers the penalised cost.
/// Returns the number of rules added. The house's other rules are not touched.
int add_leftovers(const HeightImage& image, const LeftoverOptions& options, House* house);

/// Takes dormers, chimneys and garages away whose removal lowers the penalised cost, and dormers
/// and chimneys that have grown to the bounds of their tables. Returns how many.
int drop_unpaid(const HeightImage& image, const PenaltyOptions& penalty, House* house);

}  // namespace gable
