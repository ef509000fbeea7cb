#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/roof_closing.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/residuals/height_image.h>

#include <string>

namespace gable {

/// One way to model a building, its fit written into it, and the whole of that fit.
struct BuildingCandidate {
  Building building;
  BuildingFit fit;
};

/// The outline extruded to the median of the measured heights (LoD 1.2), or to one storey where
/// nothing was measured; at least 0.5 m tall. outline: local frame of the image.
BuildingCandidate extruded_outline(const std::string& id, const HeightImage& image,
                                   PlanPolygon outline);

/// The house that was chosen, with the walls that a known outline gives it (known_walls.h; the
/// house should be no farther from the heights than `farthest`, metres). outline: local frame of
/// the image, or null where none is known.
BuildingCandidate chosen_house(const std::string& id, const HeightImage& image,
                               const HouseChoice& choice, const PlanPolygon* outline,
                               double farthest);

/// Builds the solids of a house. Where walls from an outline leave it without valid ones, it goes
/// back to its own rectangles. Returns why they cannot be used even so (see `defect_of`), or "".
std::string raise_house(const HeightImage& image, BuildingCandidate* house, BuildingModel* model);

/// The planes of a roof as a candidate; where they cannot be closed, `defect` says why.
struct PlanesCandidate {
  BuildingCandidate planes;
  std::string defect;
};

/// The planes of the roof closed over the outline of an extrusion (see `close_roof`), on its base.
PlanesCandidate closed_roof(const HeightImage& image, const RoofClosingOptions& options,
                            const Building& extrusion);

}  // namespace gable
