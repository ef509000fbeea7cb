#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/detect_house.h>
#include <gable/engine/detectors/house_from_crop.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

bool is_polygon(Foundation foundation) {
  return foundation == Foundation::kL || foundation == Foundation::kU;
}

// The parts of a foundation whose roofs are classified: every component, or the whole polygon.
std::vector<CropBits> roof_parts(const CropFoundation& foundation) {
  if (is_polygon(foundation.foundation)) return {foundation.bits()};
  std::vector<CropBits> parts;
  for (const CropRectangle& r : foundation.rectangles) parts.push_back(bits_of(r));
  return parts;
}

}  // namespace

std::string check(const DetectionOptions& options) {
  for (const std::string& bad :
       {check(options.foundations), check(options.details), check(options.garages)}) {
    if (!bad.empty()) return bad;
  }
  return {};
}

Detection detect_house(const HouseCrop& crop, const HeightImage& image, DetectorNets* nets,
                       const DetectionOptions& options) {
  CHECK(check(options).empty()) << check(options);
  const CropAnswer answer = nets->look(crop);
  Detection out;
  out.foundation = answer.foundation;
  const std::vector<CropFoundation> foundations =
      foundation_hypotheses(crop, answer, options.foundations);

  CropDetails details;
  details.dormers = find_peaks(answer.map(crop_map::kDormers), options.details);
  details.chimneys = find_peaks(answer.map(crop_map::kChimneys), options.details);
  details.garages =
      garage_candidates(answer.map(crop_map::kGarages), mask_bits(crop), options.garages);

  // Hypotheses share rectangles; each part is asked for once.
  std::vector<RoofQuestion> questions;
  std::vector<std::vector<size_t>> questions_of(foundations.size());
  for (size_t i = 0; i < foundations.size(); ++i) {
    for (const CropBits& part : roof_parts(foundations[i])) {
      const auto known =
          std::find_if(questions.begin(), questions.end(),
                       [&](const RoofQuestion& question) { return question.pixels == part; });
      questions_of[i].push_back(static_cast<size_t>(known - questions.begin()));
      if (known == questions.end()) questions.push_back({&crop, part});
    }
  }
  const std::vector<RoofAnswer> answers = nets->roofs(questions);

  for (size_t i = 0; i < foundations.size(); ++i) {
    HouseHypothesis hypothesis;
    hypothesis.iou = foundations[i].iou;
    hypothesis.corners = foundations[i].corners;
    hypothesis.log_probability = foundations[i].log_probability;
    details.roofs.clear();
    for (const size_t question : questions_of[i]) {
      const RoofAnswer::Probabilities& types = answers[question].of(foundations[i].foundation);
      const auto best = std::max_element(types.begin(), types.end());
      details.roofs.push_back(static_cast<RoofType>(best - types.begin()));
      hypothesis.log_probability +=
          std::log(std::max(1.0 * *best, std::numeric_limits<double>::min()));
    }
    hypothesis.house = house_from_crop(crop, foundations[i], details, image);
    out.houses.push_back(std::move(hypothesis));
  }
  return out;
}

AzimuthAnswer detect_azimuth(const HeightImage& image, DetectorNets* nets) {
  return nets->azimuth(make_house_crop(image, 0.0));
}

}  // namespace gable
