#include <gable/engine/evaluate/detectors/detector_truth.h>
#include <gable/grammar/ring.h>

#include <array>
#include <cmath>

namespace gable {
namespace {

CropBits bits_of_corners(const std::array<Eigen::Vector2d, 4>& c) {
  return bits_of_polygon({c[0], c[1], c[3], c[2]});
}

bool is_one_polygon(Foundation foundation) {
  return foundation == Foundation::kL || foundation == Foundation::kU;
}

}  // namespace

CropBits bits_of_polygon(const std::vector<Eigen::Vector2d>& ring) {
  CropBits bits;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (ring_holds(ring, {col + 0.5, row + 0.5})) bits.set(row, col);
    }
  }
  return bits;
}

DetectorTruth truth_of(const TrainingSample& sample) {
  DetectorTruth truth;
  truth.crop = sample.crop;
  truth.turned = sample.turned;
  truth.foundation = sample.foundation;
  truth.azimuth = sample.azimuth;
  for (const auto& corners : sample.components) {
    truth.components.push_back(bits_of_corners(corners));
    truth.outline |= truth.components.back();
  }
  if (is_one_polygon(truth.foundation)) truth.components = {truth.outline};
  truth.roofs = sample.roofs;
  truth.dormers = sample.dormers;
  truth.chimneys = sample.chimneys;
  truth.faint_dormers = sample.faint_dormers;
  truth.faint_chimneys = sample.faint_chimneys;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (sample.garages[static_cast<size_t>(row) * kCropSize + col]) truth.garages.set(row, col);
    }
  }
  return truth;
}

DetectorTruth truth_of(const AnnotatedHouse& house, const HeightImage& image, double azimuth) {
  DetectorTruth truth;
  truth.crop = make_house_crop(image, azimuth);
  truth.turned = make_house_crop(image, 0.0);
  truth.foundation = house.foundation;
  truth.azimuth = house.azimuth;
  const auto in_crop = [&](const auto& points) {
    std::vector<Eigen::Vector2d> crop;
    for (const Eigen::Vector2d& p : points) {
      crop.push_back(truth.crop.crop_from_local(p - image.origin.head<2>()));
    }
    return crop;
  };
  for (const auto& corners : house.components) {
    const std::vector<Eigen::Vector2d> c = in_crop(corners);
    truth.components.push_back(bits_of_corners({c[0], c[1], c[2], c[3]}));
    truth.outline |= truth.components.back();
  }
  if (house.components.empty()) truth.outline = bits_of_polygon(in_crop(house.outline));
  if (is_one_polygon(truth.foundation)) truth.components = {truth.outline};
  truth.roofs = house.roofs;
  truth.dormers = in_crop(house.dormers);
  truth.chimneys = in_crop(house.chimneys);
  for (const auto& ring : house.garages) truth.garages |= bits_of_polygon(in_crop(ring));
  return truth;
}

}  // namespace gable
