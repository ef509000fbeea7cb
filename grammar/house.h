#pragma once

#include <gable/grammar/rule.h>

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace gable {

/// The branches of the foundation rule (NPR section 3). kC means "not in the grammar". kMany
/// continues I, II, III: four or more I components generated in sequence, which the paper leaves
/// to C. It comes last: the detectors number the six of the paper.
enum class Foundation { kI, kII, kIII, kL, kU, kC, kMany };

/// How many there are, for arrays by Foundation.
inline constexpr int kNumFoundationTypes = 7;

/// "I", "II", "III", "L", "U", "C" or "N" (kMany).
std::string_view foundation_name(Foundation foundation);

/// Inverse of `foundation_name`. Returns false where no foundation has that name.
bool foundation_from_name(std::string_view name, Foundation* foundation);

/// A house as a derivation: foundation rule -> roof rules -> dormers and chimneys -> garages.
///
/// Frames. `world`: easting, northing, elevation in metres. `local`: world less `origin`, axes
/// kept. `house`: local turned by the azimuth about the vertical through `origin`, so that
/// footprints are axis-aligned. Every height parameter is in metres above `origin.z()`.
///
/// Invariants (see `is_well_formed`): I, II, III have 1, 2, 3 footprints of kind kFootprintI and as
/// many roofs, N four or more; L has one kFootprintL and two roofs (wing x, wing y); U one
/// kFootprintU and three roofs (base, left, right). A roof covers one rectangle, its component.
struct House {
  Foundation foundation = Foundation::kI;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world point of the house frame's origin
  Rule azimuth = make_rule(RuleKind::kAzimuth);      ///< from local x to house x, anticlockwise
  std::vector<Rule> footprints;
  std::vector<Rule> roofs;
  std::vector<Rule> dormers;
  std::vector<Rule> chimneys;
  std::vector<Rule> garages;

  int num_components() const { return static_cast<int>(roofs.size()); }

  /// Index of the footprint rule that component `component` takes its rectangle from.
  int footprint_of_component(int component) const { return footprints.size() == 1 ? 0 : component; }

  /// All rule instances in derivation order: azimuth, footprints, roofs, dormers, chimneys,
  /// garages. This order numbers the parameter blocks everywhere (solver, covariance, files).
  std::vector<Rule*> derivation();
  std::vector<const Rule*> derivation() const;

  /// Positions in `derivation()`.
  int footprint_block(int footprint) const { return 1 + footprint; }
  int roof_block(int component) const {
    return 1 + static_cast<int>(footprints.size()) + component;
  }
  int dormer_block(int dormer) const { return roof_block(num_components()) + dormer; }
  int chimney_block(int chimney) const {
    return dormer_block(static_cast<int>(dormers.size())) + chimney;
  }
  int garage_block(int garage) const {
    return chimney_block(static_cast<int>(chimneys.size())) + garage;
  }

  /// Sum of the sizes of all parameter blocks.
  int num_parameters() const;
};

/// Whether the invariants of House hold.
bool is_well_formed(const House& house);

/// Number of components of a foundation: 1, 2, 3, 2, 3; 0 for kC; 4 for kMany, which has so many or
/// more (House::num_components).
int num_components(Foundation foundation);

/// A house of the given foundation with every rule at its table's initial values: gable roofs,
/// ridges along the longer side of their wing. kMany with four components.
House make_house(Foundation foundation);

}  // namespace gable
