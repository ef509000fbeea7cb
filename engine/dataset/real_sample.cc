#include <gable/engine/dataset/real_sample.h>
#include <gable/grammar/height_field.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {

std::string check(const RealSampleOptions& options) {
  if (!(options.most_mad > 0.0 && options.most_mad <= 10.0)) return "most_mad must be in (0, 10] m";
  if (!(options.least_gap >= 0.0)) return "least_gap must be >= 0";
  if (!(options.least_probability >= 0.0 && options.least_probability <= 1.0)) {
    return "least_probability must be in [0, 1]";
  }
  if (!(options.least_iou >= 0.0 && options.least_iou <= 1.0)) return "least_iou must be in [0, 1]";
  if (!(options.beyond_area >= 0.0)) return "beyond_area must be >= 0";
  if (!(options.beyond_mad >= options.most_mad)) return "beyond_mad must be >= most_mad";
  return "";
}

double lead_of(const HouseChoice& choice) {
  if (!choice.found) return 0.0;
  double lead = std::numeric_limits<double>::infinity();
  for (const Candidate& other : choice.finalists) {
    if (other.house.foundation == choice.best.house.foundation) continue;
    lead = std::min(lead, other.cost.total - choice.best.cost.total);
  }
  return lead;
}

double outline_iou(const TileBuilding& building) {
  const HeightImage& image = building.image;
  if (!building.building.house) return 0.0;
  const HeightField field(*building.building.house);
  int both = 0, any = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d point = field.house_from_local(image.center_of(row, col));
      const bool covered = field.block_at_house(point) >= 0;
      const bool inside = image.inside[image.index(row, col)] != 0;
      both += covered && inside;
      any += covered || inside;
    }
  }
  return any > 0 ? static_cast<double>(both) / any : 0.0;
}

namespace {

/// Whether detectors, where they were asked, find a type probable.
bool is_probable(const HouseChoice& choice, Foundation type, double least) {
  return !choice.foundation || (*choice.foundation)[static_cast<size_t>(type)] >= least;
}

}  // namespace

RealSampleVerdict judge(const TileBuilding& building, const RealSampleOptions& options) {
  CHECK(check(options).empty()) << check(options);
  const double coarse = std::sqrt(std::max(1.0, building.image.gsd / 0.5));
  const double mad = building.building.quality.mad;
  const double pixels = static_cast<double>(
      std::count(building.image.inside.begin(), building.image.inside.end(), 1));
  if (building.building.status != BuildingStatus::kGrammar || mad > options.beyond_mad * coarse) {
    const double area = pixels * building.image.gsd * building.image.gsd;
    return area >= options.beyond_area &&
                   is_probable(building.choice, Foundation::kC, options.least_probability)
               ? RealSampleVerdict::kBeyondGrammar
               : RealSampleVerdict::kPoorFit;
  }
  if (mad > options.most_mad * coarse || outline_iou(building) < options.least_iou) {
    return RealSampleVerdict::kPoorFit;
  }
  const double gap = options.least_gap * std::sqrt(pixels / 100.0);
  // What has more than three blocks is C to the detectors.
  const bool many = building.building.house->foundation == Foundation::kMany;
  const Foundation type = many ? Foundation::kC : building.building.house->foundation;
  if (lead_of(building.choice) < gap ||
      !is_probable(building.choice, type, options.least_probability)) {
    return RealSampleVerdict::kCloseSecond;
  }
  return many ? RealSampleVerdict::kBeyondGrammar : RealSampleVerdict::kHouse;
}

std::optional<TrainingSample> real_sample(const TileBuilding& building,
                                          const RealSampleOptions& options) {
  const RealSampleVerdict verdict = judge(building, options);
  std::optional<TrainingSample> sample;
  if (verdict == RealSampleVerdict::kHouse) {
    const House& house = *building.building.house;
    sample = label_building(building.image, house.foundation, &house, house.azimuth[0]);
  } else if (verdict == RealSampleVerdict::kBeyondGrammar) {
    const double azimuth = building.choice.found ? building.choice.best.house.azimuth[0] : 0.0;
    sample = label_building(building.image, Foundation::kC, nullptr, azimuth);
  }
  if (sample) sample->details_known = false;
  return sample;
}

}  // namespace gable
