#pragma once

#include <gable/engine/detectors/detect_house.h>
#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/reconstruct/first_values/first_values.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace gable {

/// What the detectors say of a building: houses to start from, and how probable each foundation
/// type is.
struct DetectedValues {
  std::array<float, kNumFoundations> foundation{};  ///< probabilities, by Foundation; C among them
  std::vector<FirstValue> houses;                   ///< the most probable first; may be empty
  double azimuth = 0.0;  ///< of the crop that was looked at, radians from local x, anticlockwise
  double azimuth_confidence = 0.0;  ///< see AzimuthAnswer::confidence
};

/// Makes them of a building's heights. Called by several threads at once.
using DetectValues = std::function<DetectedValues(const HeightImage&)>;

struct DetectedValuesOptions {
  DetectionOptions detection;
  /// Where the azimuth's confidence is less, the crop is turned by what the classical search finds
  /// first, [0, 2]: 0 never does so, above 1 always.
  double least_confidence = 0.5;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const DetectedValuesOptions& options);

/// Asks the detectors: the azimuth from the crop at azimuth 0, the rest from the crop turned by it.
/// Throws Error where a network fails.
DetectedValues detect_values(const HeightImage& image, DetectorNets* nets,
                             const DetectedValuesOptions& options = {});

}  // namespace gable
