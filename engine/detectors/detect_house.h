#pragma once

#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/detectors/foundation_hypotheses.h>
#include <gable/engine/detectors/garage_candidates.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/detectors/peaks.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <string>
#include <vector>

namespace gable {

struct DetectionOptions {
  FoundationOptions foundations;
  /// Dormers and chimneys, see PeakOptions; centres lie close together.
  PeakOptions details = {.threshold = 0.5, .radius = 2, .at_most = 12};
  GarageOptions garages;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const DetectionOptions& options);

/// A house as the detectors see it.
struct HouseHypothesis {
  House house;                   ///< first values, see house_from_crop.h
  double iou = 0.0;              ///< of the foundation with the pixels that it should cover
  double corners = 0.0;          ///< mean value of its corners
  double log_probability = 0.0;  ///< of the foundation's type and of the roofs' types
};

/// What the detectors say of one crop.
struct Detection {
  std::array<float, kNumFoundations> foundation{};  ///< probabilities, by Foundation; C among them
  std::vector<HouseHypothesis> houses;  ///< in the order of foundation_hypotheses; empty where
                                        ///< there is no building in the crop
};

/// Runs the detectors on the rectified crop of an image and makes houses of what they say: for
/// every foundation hypothesis one, each roof of its most probable type. All roofs of all
/// hypotheses are asked for in one batch. Throws Error where a network fails.
Detection detect_house(const HouseCrop& crop, const HeightImage& image, DetectorNets* nets,
                       const DetectionOptions& options = {});

/// The azimuth of an image's building by the detectors, in [0, pi/2), from local x, anticlockwise:
/// that of make_house_crop(image, 0).
AzimuthAnswer detect_azimuth(const HeightImage& image, DetectorNets* nets);

}  // namespace gable
