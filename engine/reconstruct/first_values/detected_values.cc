#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/engine/reconstruct/first_values/detected_values.h>
#include <glog/logging.h>

#include <string>
#include <utility>

namespace gable {
namespace {

// Directions nearer than this are one, radians; only the first is of interest here.
constexpr double kSeparation = 0.1;

}  // namespace

std::string check(const DetectedValuesOptions& options) {
  if (const std::string error = check(options.detection); !error.empty()) return error;
  if (!(options.least_confidence >= 0.0 && options.least_confidence <= 2.0)) {
    return "least_confidence must lie in [0, 2]";
  }
  return "";
}

DetectedValues detect_values(const HeightImage& image, DetectorNets* nets,
                             const DetectedValuesOptions& options) {
  CHECK(check(options).empty()) << check(options);
  DetectedValues values;
  const AzimuthAnswer answer = detect_azimuth(image, nets);
  values.azimuth = answer.angle();
  values.azimuth_confidence = answer.confidence();
  std::string azimuth = "azimuth network";
  if (values.azimuth_confidence < options.least_confidence) {
    azimuth = "where outline and roof rise, the network being unsure";
    values.azimuth = azimuth_candidates(image, kSeparation).front().azimuth;
  }
  Detection detection =
      detect_house(make_house_crop(image, values.azimuth), image, nets, options.detection);
  values.foundation = detection.foundation;
  const OriginsByKind origins = {azimuth, "corners of the foundation network",
                                 "roof network, heights inside", "peaks of the detail network",
                                 "pixels of the garage network"};
  for (HouseHypothesis& hypothesis : detection.houses) {
    FirstValue value;
    value.origins = origins_of(hypothesis.house, origins);
    value.house = std::move(hypothesis.house);
    value.source = ValueSource::kDetectors;
    value.log_probability = hypothesis.log_probability;
    values.houses.push_back(std::move(value));
  }
  return values;
}

}  // namespace gable
