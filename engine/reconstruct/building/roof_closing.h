#pragma once

#include <gable/engine/closing/closing_options.h>
#include <gable/engine/io/models/building.h>
#include <gable/engine/reconstruct/first_values/house_scales.h>
#include <gable/residuals/height_image.h>

#include <string>

namespace gable {

/// How a building outside the grammar is closed from the planes of its roof.
struct RoofClosingOptions {
  HouseScalesOptions scales;
  ClosingOptions closing;
  /// Corners of the outline nearer than this to the line between their neighbours are left out,
  /// metres, [0, 10].
  double outline_tolerance = 0.15;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RoofClosingOptions& options);

/// Gives `building`, an extrusion whose outline, height and base are set and whose origin is the
/// image's, the roof that the planes of its heights make over the outline: the planes at the scale
/// of LoD 2 (HouseScales::roofs), closed by close_planes. Its status becomes kPlanes. Returns why
/// there is no such roof, and leaves the building alone then; "" otherwise.
std::string close_roof(const HeightImage& image, const RoofClosingOptions& options,
                       Building* building);

}  // namespace gable
