#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/known_outline.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace gable {

/// A house seen from above whose walls may be known: then its derivation gives the roofs and the
/// outline the plan. The house ends at the outline and fills it as far as its blocks reach with
/// the margins of outline_margins.h, so that party walls and oblique fronts are where they are
/// known to be, and rectangles that reach beyond them cost nothing.
class OutlinedHouse {
 public:
  /// `outline`: local frame (world less House::origin), metres; empty: the house's own plan.
  OutlinedHouse(const House& house, KnownOutline outline);

  /// What is seen at a point.
  struct Sample {
    int block = -1;       ///< index into field().blocks()
    double height = 0.0;  ///< metres above House::origin
  };

  /// What stands at a point of the local frame; nothing where the ground is seen.
  std::optional<Sample> at_local(const Eigen::Vector2d& local) const;

  bool has_outline() const { return !outline_.empty(); }
  const HeightField& field() const { return field_; }

 private:
  HeightField field_;
  KnownOutline outline_;
  std::vector<Block<double>> ground_blocks_;  ///< the first of the field's blocks
};

}  // namespace gable
