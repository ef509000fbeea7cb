#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/house_solids.h>

#include <string>
#include <vector>

namespace gable {

/// Thickness and overhang of roofs (NPR section 7, which enlarges roofs by 15 % and thickens them
/// by 0.35 m along gravity).
struct RoofSlabOptions {
  double thickness = 0.0;  ///< measured vertically, metres: 0 (no slabs) or in [0.05, 1]
  double overhang = 0.0;   ///< beyond the walls, horizontally, metres, [0, 1]; needs a thickness

  bool wanted() const { return thickness > 0.0; }
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RoofSlabOptions& options);

/// LoD 2.3 of a house: its roofs as slabs of their own (PartRole::kRoofSlab), and the parts of LoD
/// 2.2 with walls that end under them. Local frame, metres.
///
/// Heights are measured on top of roofs, so the roof of LoD 2.2 is a slab's upper face and the
/// walls become lower by the thickness. At eaves the planes continue downwards, at gables
/// sideways. All components, garages and dormers have slabs; chimneys pass through them. Where a
/// slab would enter something else it ends, see SlabPlan. `neighbours` are outlines of other
/// buildings, local frame: overhangs end at them, so that none lies across a party wall.
///
/// Each slab is a closed solid with roof faces above, ground faces below and walls at its rim;
/// slabs that meet in valleys are one. All solids pass check_solid, before and after rounding to
/// 0.1 mm; blocks are aligned and moved by millimetres for it as in build_house_solids. Where that
/// fails dormers lose their slabs, then the house, with a line in `dropped` and, for the house, no
/// parts. Deterministic.
HouseSolids build_roof_slabs(const House& house, double base, const RoofSlabOptions& options,
                             const std::vector<PlanPolygon>& neighbours = {});

}  // namespace gable
