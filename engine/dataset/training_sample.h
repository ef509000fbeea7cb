#pragma once

#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/training_scene.h>
#include <gable/residuals/height_image.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace gable {

/// One building with what the detectors should say of it; docs/detectors.md lists the targets.
struct TrainingSample {
  HouseCrop crop;    ///< rectified
  HouseCrop turned;  ///< the same building at azimuth 0
  Foundation foundation = Foundation::kC;
  double azimuth = 0.0;  ///< of the turned crop, [0, pi / 2), radians; NaN where unknown
  std::vector<RoofType> roofs;
  std::vector<std::array<Eigen::Vector2d, 4>> components;  ///< crop pixels, as RectangleCorner
  std::vector<CropCorner> corners;
  std::vector<Eigen::Vector2d> dormers;   ///< crop pixels
  std::vector<Eigen::Vector2d> chimneys;  ///< crop pixels
  /// Those that are there but that the heights do not show.
  std::vector<Eigen::Vector2d> faint_dormers, faint_chimneys;
  std::array<uint8_t, kCropPixels> garages{};
  bool details_known = true;  ///< whether dormers, chimneys and garages are all that there are
};

/// What the roof classifiers should say of a house: one type a component of I, II, III, one type
/// for the whole of L and U, which is hip where the end of any wing is hipped.
std::vector<RoofType> roof_types(const House& house);

/// Crops and targets of a building whose house is known (null for C) from its height image. `crop`
/// is cut at `azimuth` (radians, local). All dormers and chimneys of the house become targets.
TrainingSample label_building(const HeightImage& image, Foundation foundation, const House* house,
                              double azimuth);

/// The sample of a scene: the building is found in the heights, or cut out by its outline, as
/// reconstruction does; the crop is turned off the true azimuth by what rectification may miss.
/// Only dormers and chimneys that stand out in the heights become targets. Nothing where no
/// building is found.
std::optional<TrainingSample> make_training_sample(const TrainingScene& scene, Random* random);

}  // namespace gable
