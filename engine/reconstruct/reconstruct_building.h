#pragma once

#include <gable/engine/io/building.h>
#include <gable/engine/io/building_model.h>
#include <gable/engine/reconstruct/detected_values.h>
#include <gable/engine/reconstruct/house_choice.h>
#include <gable/engine/reconstruct/house_scales.h>
#include <gable/engine/reconstruct/roof_closing.h>
#include <gable/engine/reconstruct/scale_values.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/residuals/height_image.h>

#include <string>

namespace gable {

struct BuildingOptions {
  HouseChoiceOptions choice;
  bool scales = true;  ///< first values from the planes at the building's structural scales
  HouseScalesOptions house_scales;
  ScaleValuesOptions scale_values;
  RoofClosingOptions closing;
  /// Buildings with less measured area than this become extrusions, square metres, [0, 1000].
  double least_area = 4.0;
  double outline_tolerance = 0.5;  ///< of outlines traced from pixels, metres, [0.01, 10]
  /// A house is kept unless the extruded outline is nearer to the heights by more than this,
  /// metres, [0, 10].
  double extrusion_margin = 0.02;
  /// Where the outline is known, a house gives way to the closed planes of its roof if it is
  /// farther than this from the heights, metres, [0, 1000],
  double planes_from = 0.45;
  /// and the planes are nearer by more than this, metres, [0, 1000], and by more than
  /// `planes_ratio`; 1000: never.
  double planes_margin = 0.25;
  /// Distance of the planes over that of the house that they must stay below, [0, 1].
  double planes_ratio = 0.6;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const BuildingOptions& options);

/// A building with the solids that model files carry.
struct ReconstructedBuilding {
  Building building;
  BuildingModel model;
  HouseChoice choice;  ///< what the house was chosen from; empty where none was looked for
};

/// Reconstructs one building from its heights: the house that `choose_house` finds, unless the
/// outline extruded to the median height (LoD 1.2) is clearly nearer to the heights, or no valid
/// solid can be made of the house. Then the planes of the roof closed over the outline, or where
/// these are no nearer than it or cannot be closed that extrusion, with the reason. All are
/// measured over the inside pixels, a miss counting as terrain, with what they cover beyond them
/// added. `outline` is the known outline in the image's local frame, or null: then it is traced
/// from the inside pixels. `detect` asks the detectors for first values; it may be empty. Always
/// returns a building.
ReconstructedBuilding reconstruct_building(const std::string& id, const HeightImage& image,
                                           const PlanPolygon* outline,
                                           const BuildingOptions& options,
                                           const DetectValues& detect = {});

/// Refines a house against its heights; house.origin must be image->origin. The start is kept, with
/// a reason, where refinement does not lower the cost of its last stage or leaves no valid solid.
/// The inside pixels, which quality is measured over, become those that the result covers.
ReconstructedBuilding refine_building(const Building& start, const RefinementOptions& options,
                                      HeightImage* image);

}  // namespace gable
