#include <gable/engine/detectors/foundation_hypotheses.h>
#include <gable/engine/detectors/peaks.h>
#include <gable/engine/evaluate/detectors/detector_scores.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

template <size_t n>
int most_probable(const std::array<float, n>& probabilities) {
  return static_cast<int>(std::max_element(probabilities.begin(), probabilities.end()) -
                          probabilities.begin());
}

/// The best foundation of one type, whatever the classifier says.
double iou_of_type(const DetectorTruth& truth, CropAnswer answer) {
  answer.foundation.fill(0.0f);
  answer.foundation[static_cast<size_t>(truth.foundation)] = 1.0f;
  for (const CropFoundation& found : foundation_hypotheses(truth.crop, answer)) {
    if (found.foundation == truth.foundation) {
      return intersection_over_union(found.bits(), truth.outline);
    }
  }
  return 0.0;
}

void add(const DetectionScore& one, DetectionScore* sum) {
  sum->truth += one.truth;
  sum->found += one.found;
  sum->correct += one.correct;
}

void add_detections(const CropAnswer& answer, int map, const std::vector<Eigen::Vector2d>& truth,
                    const std::vector<Eigen::Vector2d>& faint, DetectionScore* score) {
  std::vector<Eigen::Vector2d> found;
  for (const Peak& peak : find_peaks(answer.map(map))) found.push_back(peak.crop);
  add(score_detections(found, truth, kDetectionPixels, faint), score);
}

/// The distance of two angles modulo a quarter turn.
double quarter_distance(double a, double b) { return std::abs(std::remainder(a - b, 0.5 * M_PI)); }

}  // namespace

DetectorScores& DetectorScores::operator+=(const DetectorScores& other) {
  for (size_t i = 0; i < confusion.size(); ++i) {
    for (size_t j = 0; j < confusion[i].size(); ++j) confusion[i][j] += other.confusion[i][j];
  }
  for (size_t i = 0; i < roofs.size(); ++i) {
    roofs[i].right += other.roofs[i].right;
    roofs[i].all += other.roofs[i].all;
  }
  for (size_t i = 0; i < foundation_iou.size(); ++i) foundation_iou[i] += other.foundation_iou[i];
  add(other.dormers, &dormers);
  add(other.chimneys, &chimneys);
  garage_iou += other.garage_iou;
  azimuth_errors.insert(azimuth_errors.end(), other.azimuth_errors.begin(),
                        other.azimuth_errors.end());
  return *this;
}

int DetectorScores::houses() const {
  int sum = 0;
  for (const auto& row : confusion) {
    for (const int count : row) sum += count;
  }
  return sum;
}

double DetectorScores::foundation_accuracy() const {
  int right = 0;
  for (size_t i = 0; i < confusion.size(); ++i) right += confusion[i][i];
  return houses() > 0 ? static_cast<double>(right) / houses() : 0.0;
}

double DetectorScores::median_azimuth_error() const {
  if (azimuth_errors.empty()) return 0.0;
  std::vector<double> errors = azimuth_errors;
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  return errors[errors.size() / 2];
}

void add_score(const DetectorTruth& truth, DetectorNets* nets, DetectorScores* scores) {
  const CropAnswer answer = nets->look(truth.crop);
  const auto type = static_cast<size_t>(truth.foundation);
  ++scores->confusion[type][static_cast<size_t>(most_probable(answer.foundation))];
  if (std::isfinite(truth.azimuth)) {
    scores->azimuth_errors.push_back(
        quarter_distance(nets->azimuth(truth.turned).angle(), truth.azimuth));
  }
  if (truth.foundation == Foundation::kC) return;
  scores->foundation_iou[type].add(iou_of_type(truth, answer));
  const size_t group = truth.foundation == Foundation::kL   ? 1
                       : truth.foundation == Foundation::kU ? 2
                                                            : 0;
  for (size_t i = 0; i < truth.components.size() && i < truth.roofs.size(); ++i) {
    const RoofAnswer roof = nets->roof(truth.crop, truth.components[i]);
    ++scores->roofs[group].all;
    scores->roofs[group].right +=
        most_probable(roof.of(truth.foundation)) == static_cast<int>(truth.roofs[i]);
  }
  add_detections(answer, crop_map::kDormers, truth.dormers, truth.faint_dormers, &scores->dormers);
  add_detections(answer, crop_map::kChimneys, truth.chimneys, truth.faint_chimneys,
                 &scores->chimneys);
  if (!truth.garages.empty()) {
    scores->garage_iou.add(intersection_over_union(
        pixels_above(answer.map(crop_map::kGarages), GarageOptions().threshold), truth.garages));
  }
}

}  // namespace gable
