#pragma once

#include <gable/engine/reconstruct/choice/leftovers.h>
#include <gable/engine/reconstruct/first_values/first_values.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <optional>
#include <string>
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
  /// How much the probabilities of the foundation types count where first values come with them,
  /// [0, 100]. See `foundation_charges`.
  double type_weight = 3.0;
  double least_probability = 0.003;  ///< a type counts as at least so probable, (0, 1]
  /// Hypotheses of the classical search of types less probable than this are dropped, [0, 1], but
  /// never all.
  double skipped_probability = 0.0;

  /// The best hypotheses grow to so many blocks where these pay, [1, 20]. See grow_blocks.h.
  int most_blocks = 8;
  int growing = 2;  ///< how many hypotheses are grown, [0, 20]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HouseChoiceOptions& options);

/// How far a hypothesis came.
enum class ChoiceStage {
  kWide,      ///< refined with a wide support
  kPriced,    ///< refined with a narrow one, and priced
  kFinished,  ///< with its details, a finalist
};

/// One hypothesis after its refinement.
struct Candidate {
  House house;
  PenalisedCost cost;
  ValueSource source = ValueSource::kClassical;  ///< of its first values
  int hypothesis = -1;                           ///< position in HouseChoice::first_values
  ChoiceStage stage = ChoiceStage::kWide;
};

/// The house chosen, and what it was chosen from.
struct HouseChoice {
  bool found = false;  ///< false: no block explains the building better than bare ground
  Candidate best;
  RefinementSummary summary;         ///< of the last refinement of the best
  std::vector<Candidate> finalists;  ///< best first, the winner among them
  /// The others in the order in which they were given up, with what they cost then: of kWide the
  /// wide stage's cost, which ranks and compares with nothing else.
  std::vector<Candidate> given_up;
  std::vector<FirstValue> first_values;  ///< what was refined
  double noise = 0.0;                    ///< of the heights as used to price parameters, metres
  /// Probabilities of the foundation types, C among them, where they were known.
  std::optional<std::array<float, kNumFoundations>> foundation;

  int num_hypotheses() const { return static_cast<int>(first_values.size()); }
  /// How many of them have their first values from a source.
  int num_from(ValueSource source) const;
};

/// What each foundation, C left out, is charged in the penalised cost: twice the negative logarithm
/// of its probability among the five, which is at least `least_probability`, times `type_weight`.
/// N, which the detectors do not name, is charged as III.
std::array<double, kNumFoundationTypes> foundation_charges(
    const std::array<float, kNumFoundations>& probabilities, const HouseChoiceOptions& options);

/// The last stage that a chosen house is refined in: what it minimises is what the house is best
/// at.
RefinementStage last_stage(bool outline_known);

/// Chooses a house: first values of every foundation type from the heights and those of `others`;
/// all refined, the best few refined to the end with their dormers, chimneys and garages and
/// simplified roofs, and the least penalised cost wins, in which the probabilities of `others`
/// count. The houses of `others` have the image's origin, as has the one chosen.
HouseChoice choose_house(const HeightImage& image, const HouseChoiceOptions& options,
                         const FirstValues& others = {});

}  // namespace gable
