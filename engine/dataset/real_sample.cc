#include <gable/engine/dataset/real_sample.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {

std::string check(const RealSampleOptions& options) {
  if (!(options.most_mad > 0.0 && options.most_mad <= 10.0)) return "most_mad must be in (0, 10] m";
  if (!(options.least_gap >= 0.0)) return "least_gap must be >= 0";
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

RealSampleVerdict judge(const TileBuilding& building, const RealSampleOptions& options) {
  CHECK(check(options).empty()) << check(options);
  const double coarse = std::sqrt(std::max(1.0, building.image.gsd / 0.5));
  const double mad = building.building.quality.mad;
  if (building.building.status != BuildingStatus::kGrammar || mad > options.beyond_mad * coarse) {
    return RealSampleVerdict::kBeyondGrammar;
  }
  if (mad > options.most_mad * coarse) return RealSampleVerdict::kPoorFit;
  const double pixels = static_cast<double>(
      std::count(building.image.inside.begin(), building.image.inside.end(), 1));
  const double gap = options.least_gap * std::sqrt(pixels / 100.0);
  return lead_of(building.choice) < gap ? RealSampleVerdict::kCloseSecond
                                        : RealSampleVerdict::kHouse;
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
