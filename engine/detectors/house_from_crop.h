#pragma once

#include <gable/engine/detectors/crop_foundation.h>
#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/garage_candidates.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/detectors/peaks.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

/// What the detectors say of a crop besides a foundation.
struct CropDetails {
  std::vector<RoofType> roofs;  ///< of every component of an I, II or III; the one of an L or U
  std::vector<Peak> dormers;    ///< their centres
  std::vector<Peak> chimneys;
  std::vector<CropGarage> garages;
};

/// First values of a house (NPR sections 4.1-4.4), in the frame of the image: its origin is the
/// image's, its azimuth the crop's, plus quarter turns where the grammar's L or U wants them.
/// `image` is what the crop was made of.
///
/// - Footprints are the foundation's rectangles; of L and U tied as grammar/wing_polygons.h does.
/// - Eaves are the mean of the lowest tenth of the heights over a component, tops that of the
///   highest twentieth, flat roofs lie at the median; see component_heights.h.
/// - The ridge of a free rectangle runs across the way that most of its normals lean; where they do
///   not say, along the longer side. Those of L and U run along their wings.
/// - Hips take their share of the length, and dormers and chimneys their size, from the tables of
///   grammar/rule.h. A dormer's height is what the image shows at its centre, a chimney's 2.5 m
///   over the roof. Dormers outside all components and chimneys further than a metre away from them
///   are left out.
/// - A garage is as high as the median over it. An L-shaped one that the grammar's L, which does
///   not turn, cannot say becomes two rectangles that touch.
///
/// All values lie within the bounds of their tables.
House house_from_crop(const HouseCrop& crop, const CropFoundation& foundation,
                      const CropDetails& details, const HeightImage& image);

/// The axis along which the ridge of a rectangle runs, by the crop's normals and its sides.
Axis ridge_axis(const HouseCrop& crop, const CropRectangle& rectangle);

}  // namespace gable
