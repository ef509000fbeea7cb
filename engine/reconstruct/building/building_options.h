#pragma once

#include <gable/engine/reconstruct/building/roof_closing.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gable/engine/reconstruct/first_values/scale_values.h>

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

  /// Whether planes may take the place of a house that is `distance` metres from the heights.
  bool planes_may_replace(double distance) const;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const BuildingOptions& options);

}  // namespace gable
