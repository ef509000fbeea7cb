#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

#include <array>
#include <string>

namespace gable {

/// What of the prior of English suburban houses can be set; docs/prior.md has the whole table.
struct PriorOptions {
  /// Relative weights of I, II, III, L, U, each >= 0, not all 0.
  std::array<double, 5> foundation_weights = {1.0, 1.0, 1.0, 1.0, 1.0};
  double dormer_share = 0.25;   ///< houses that try to have 1-3 dormers, [0, 1]
  double chimney_share = 0.65;  ///< houses that try to have 1-2 chimneys, [0, 1]
  double garage_share = 0.45;   ///< houses that try to have 1-2 garages, [0, 1]
  double max_diagonal = 30.0;   ///< of the plan with garages, metres, >= 26: fits a 32 m crop

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// A random derivation: a house of the given type (not kC) in its own frame, origin zero, azimuth
/// uniform in [0, 2 pi), the components' bounding box centred. Every parameter lies within the
/// bounds of parameter_specs, and `is_distinct` holds.
House random_house(Foundation foundation, Random* random,
                   const PriorOptions& options = PriorOptions());

/// The same, with the foundation drawn by options.foundation_weights.
House random_house(Random* random, const PriorOptions& options = PriorOptions());

}  // namespace gable
