#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>

namespace gable {

/// Metadata of one parameter of a rule. The tables behind `parameter_specs` are the only place
/// that knows names, units, bounds and defaults; the solver, input, output and docs read them.
struct ParameterSpec {
  std::string_view name;
  std::string_view unit;    ///< "m" (metres), "rad" (radians) or "1" (a ratio)
  double lower;             ///< inclusive bound kept by the solver; -inf: free
  double upper;             ///< inclusive bound kept by the solver; +inf: free
  double initial;           ///< first value where nothing better is known
  std::string_view source;  ///< where `initial` comes from
};

/// The kinds of rule that carry parameters. One instance of a rule is one parameter block.
/// NPR section 3; values are stored in files by name, see `rule_name`.
enum class RuleKind {
  kAzimuth,
  kFootprintI,
  kFootprintL,
  kFootprintU,
  kRoofFlat,
  kRoofGable,
  kRoofHip,
  kRoofMansard,
  kDormer,
  kChimney,
  kGarageI,
  kGarageL,
};

inline constexpr int kNumRuleKinds = 12;
inline constexpr int kMaxRuleParameters = 8;

/// Parameters of a rule, in the order in which their values are stored.
std::span<const ParameterSpec> parameter_specs(RuleKind kind);

/// Stable name of a rule kind as written to files, e.g. "footprint_l".
std::string_view rule_name(RuleKind kind);

/// Inverse of `rule_name`. Returns false where no rule has that name.
bool rule_kind_from_name(std::string_view name, RuleKind* kind);

/// Whether a rule is a roof of a component: flat, gable, hip or mansard.
bool is_roof(RuleKind kind);

/// What people call a kind of roof: "flat", "gable", "hip" or "mansard". Only for roofs.
std::string_view roof_name(RuleKind kind);

/// Axis of the house frame.
enum class Axis { kX, kY };

// Positions of parameters in Rule::values, by rule.
namespace param {
namespace rectangle {  // kFootprintI, kGarageI
enum { kCenterX, kCenterY, kLength, kWidth };
}
/// Wing x is the rectangle from the corner along +x, wing y the one along +y; both share the
/// corner, so the polygon's six distinct coordinates are corner, corner + lengths and corner +
/// widths. Kept as sizes so that positivity is a bound.
namespace l_polygon {  // kFootprintL, kGarageL
enum { kCornerX, kCornerY, kWingXLength, kWingXWidth, kWingYLength, kWingYWidth };
}
/// The base runs from the corner along +x; the left wing stands at its start, the right wing at
/// its end, both along +y, their lengths measured from the corner's y.
namespace u_polygon {  // kFootprintU
enum {
  kCornerX,
  kCornerY,
  kBaseLength,
  kBaseWidth,
  kLeftLength,
  kLeftWidth,
  kRightLength,
  kRightWidth
};
}
namespace roof {  // kRoofFlat has eaves only, kRoofGable eaves and rise
enum { kEaves, kRise, kHipStart, kHipEnd };
}
/// Eaves and rise are those of every roof. Both long sides are broken: the steep lower part takes
/// the share kBreakRun of the half width and climbs the share kBreakHeight of the rise. The table
/// bounds the first from above and the second from below by one half, so that the lower part is
/// never the less steep one.
namespace mansard {  // kRoofMansard
enum { kEaves, kRise, kBreakHeight, kBreakRun };
}
namespace dormer {
enum { kCenterX, kCenterY, kWidth, kDepth, kEaves, kRise };
}
namespace chimney {
enum { kCenterX, kCenterY, kSide, kHeight };
}
namespace garage {  // height follows the polygon's parameters
inline constexpr int kHeightI = 4;
inline constexpr int kHeightL = 6;
}  // namespace garage
}  // namespace param

/// One instance of a rule: a parameter block of `size()` values.
struct Rule {
  RuleKind kind = RuleKind::kAzimuth;
  std::array<double, kMaxRuleParameters> values{};
  /// Roofs: the axis of the house frame along which the ridge runs.
  Axis ridge = Axis::kX;
  /// Dormers: the component (index into House::roofs) on whose roof it stands. Otherwise -1.
  int component = -1;

  int size() const;
  std::span<double> parameters() { return {values.data(), static_cast<size_t>(size())}; }
  std::span<const double> parameters() const {
    return {values.data(), static_cast<size_t>(size())};
  }
  double operator[](int i) const { return values[i]; }
  double& operator[](int i) { return values[i]; }
};

/// A rule with the initial values of its table.
Rule make_rule(RuleKind kind);

}  // namespace gable
