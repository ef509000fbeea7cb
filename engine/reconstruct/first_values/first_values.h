#pragma once

#include <gable/engine/detectors/detector_nets.h>
#include <gable/grammar/house.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

/// Where first values come from: the search in the heights (block_search.h), the learned detectors
/// (detected_values.h), the planes at the house's structural scales (scale_values.h).
enum class ValueSource { kClassical, kDetectors, kScales };

inline constexpr int kNumValueSources = 3;

/// "classical", "detectors" or "scales".
std::string_view value_source_name(ValueSource source);

/// A house to start from.
struct FirstValue {
  House house;
  ValueSource source = ValueSource::kClassical;
  /// Of each rule of house.derivation(): what its values were read from, in a few words; or none at
  /// all.
  std::vector<std::string> origins;
  double log_probability = 0.0;  ///< of the foundation's and the roofs' types, as far as known
};

/// What a house is chosen from beside the classical search: houses to start from, and how probable
/// each foundation type is, whichever source a hypothesis is from.
struct FirstValues {
  std::vector<FirstValue> houses;
  /// By Foundation, C among them; none: nothing is known of the types.
  std::optional<std::array<float, kNumFoundations>> foundation;
};

/// What the rules of a house were read from where that depends on the kind of rule alone.
struct OriginsByKind {
  std::string azimuth, footprint, roof, detail, garage;
};

/// The same for every rule of `house`, in the order of its derivation.
std::vector<std::string> origins_of(const House& house, const OriginsByKind& by_kind);

}  // namespace gable
