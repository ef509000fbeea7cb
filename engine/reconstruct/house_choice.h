#pragma once

#include <gable/engine/reconstruct/detected_values.h>
#include <gable/engine/reconstruct/leftovers.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

/// How a house is chosen among hypotheses.
struct HouseChoiceOptions {
  int per_foundation = 2;  ///< hypotheses of each foundation type and azimuth, [1, 10]
  int finalists = 5;       ///< hypotheses refined to the end, [1, 20]
  /// Hypotheses whose robust cost is more than this times the least are given up early, > 1.
  double hopeless = 1.6;
  /// The outline is known: pixels beyond it hold ground, and misses inside it count by their
  /// height.
  bool outline_known = false;
  double least_noise = 0.1;  ///< of the heights, metres, > 0
  double most_noise = 0.4;   ///< metres, >= least_noise

  bool classical = true;  ///< search for first values in the heights
  /// How much the probabilities of the foundation types count where detected values come with
  /// them, [0, 100]. See `foundation_charges`.
  double type_weight = 16.0;
  double least_probability = 0.003;  ///< a type counts as at least so probable, (0, 1]
  /// Hypotheses of the classical search of types less probable than this are dropped, [0, 1], but
  /// never all.
  double skipped_probability = 0.0;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HouseChoiceOptions& options);

/// Where first values come from.
enum class ValueSource { kClassical, kDetectors };

/// "classical" or "detectors".
std::string_view value_source_name(ValueSource source);

/// One hypothesis after its refinement.
struct Candidate {
  House house;
  PenalisedCost cost;
  ValueSource source = ValueSource::kClassical;  ///< of its first values
};

/// The house chosen, and what it was chosen from.
struct HouseChoice {
  bool found = false;  ///< false: no block explains the building better than bare ground
  Candidate best;
  RefinementSummary summary;         ///< of the last refinement of the best
  std::vector<Candidate> finalists;  ///< best first, the winner among them
  int hypotheses = 0;                ///< how many were refined
  int detected_hypotheses = 0;       ///< how many of them had first values from the detectors
  double noise = 0.0;                ///< of the heights as used to price parameters, metres
  /// Probabilities of the foundation types, C among them, where there were detected values.
  std::optional<std::array<float, kNumFoundations>> foundation;
};

/// What each foundation, C left out, is charged in the penalised cost: twice the negative logarithm
/// of its probability among the five, which is at least `least_probability`, times `type_weight`.
std::array<double, kNumFoundations> foundation_charges(
    const std::array<float, kNumFoundations>& probabilities, const HouseChoiceOptions& options);

/// The last stage that a chosen house is refined in: what it minimises is what the house is best
/// at.
RefinementStage last_stage(bool outline_known);

/// Chooses a house: first values of every foundation type from the heights and, where `detected` is
/// not null, from there as well; all refined, the best few refined to the end with their dormers,
/// chimneys and garages and simplified roofs, and the least penalised cost wins, in which the
/// probabilities of `detected` count. Its houses have the image's origin.
HouseChoice choose_house(const HeightImage& image, const HouseChoiceOptions& options,
                         const DetectedValues* detected = nullptr);

}  // namespace gable
