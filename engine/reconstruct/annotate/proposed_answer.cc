#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/reconstruct/annotate/proposed_answer.h>
#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/grammar/block.h>
#include <gable/grammar/plan_outline.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kQuarter = 0.5 * M_PI;

// Two candidates of azimuth nearer than this are one, radians.
constexpr double kAzimuthSeparation = 0.05;

RoofType type_of(const Rule& roof) {
  if (roof.kind == RuleKind::kRoofFlat) return RoofType::kFlat;
  return roof.kind == RuleKind::kRoofHip ? RoofType::kHip : RoofType::kGable;
}

/// Points of a house frame as pixels of a crop.
class ToCrop {
 public:
  ToCrop(const House& house, const CropFrame& frame) : house_(house), frame_(frame) {}

  Eigen::Vector2d operator()(double x, double y) const {
    const Eigen::Rotation2Dd local_from_house(house_.azimuth[0]);
    return frame_.crop_from_world(house_.origin.head<2>() +
                                  local_from_house * Eigen::Vector2d(x, y));
  }
  CropRectangle operator()(const Block<double>& block) const {
    using namespace block_value;
    const Eigen::Vector2d a = (*this)(block[kX0], block[kY0]), b = (*this)(block[kX1], block[kY1]);
    const Eigen::Vector2d low = a.cwiseMin(b), high = a.cwiseMax(b);
    return {low.x(), high.x(), low.y(), high.y()};
  }

 private:
  const House& house_;
  const CropFrame& frame_;
};

std::vector<Eigen::Vector2d> garage_ring(const Rule& garage, const ToCrop& to_crop) {
  if (garage.kind == RuleKind::kGarageI) {
    using namespace param::rectangle;
    const double x0 = garage[kCenterX] - 0.5 * garage[kLength], x1 = x0 + garage[kLength];
    const double y0 = garage[kCenterY] - 0.5 * garage[kWidth], y1 = y0 + garage[kWidth];
    return {to_crop(x0, y0), to_crop(x1, y0), to_crop(x1, y1), to_crop(x0, y1)};
  }
  using namespace param::l_polygon;
  const double x = garage[kCornerX], y = garage[kCornerY];
  const double xl = garage[kWingXLength], xw = garage[kWingXWidth];
  const double yl = garage[kWingYLength], yw = garage[kWingYWidth];
  return {to_crop(x, y),           to_crop(x + xl, y),      to_crop(x + xl, y + xw),
          to_crop(x + yw, y + xw), to_crop(x + yw, y + yl), to_crop(x, y + yl)};
}

void propose_polygon(const House& house, HouseAnswer* answer) {
  House bare = house;
  bare.garages.clear();
  const std::vector<PlanPolygon> pieces = plan_outline(bare);
  for (const Eigen::Vector2d& p : pieces.front().outer) {
    answer->polygon.push_back(answer->frame.crop_from_world(house.origin.head<2>() + p));
  }
  std::vector<RoofType> types;
  for (const Rule& roof : house.roofs) types.push_back(type_of(roof));
  const auto any = [&](RoofType type) {
    return std::find(types.begin(), types.end(), type) != types.end();
  };
  answer->roofs = {any(RoofType::kHip)     ? RoofType::kHip
                   : any(RoofType::kGable) ? RoofType::kGable
                                           : RoofType::kFlat};
}

void propose_house(const House& house, HouseAnswer* answer) {
  // What has more than three blocks is C to annotators: an outline, no roofs.
  const bool many = house.foundation == Foundation::kMany;
  answer->foundation = many ? Foundation::kC : house.foundation;
  const ToCrop to_crop(house, answer->frame);
  if (num_annotated_rectangles(house.foundation) == 0) {
    propose_polygon(house, answer);
    if (many) answer->roofs.clear();
  } else {
    const std::vector<Block<double>> blocks = expand_blocks(house);
    for (int i = 0; i < house.num_components(); ++i) {
      answer->rectangles.push_back(to_crop(blocks[i]));
      answer->roofs.push_back(type_of(house.roofs[i]));
    }
  }
  for (const Rule& dormer : house.dormers) {
    answer->dormers.push_back(
        to_crop(dormer[param::dormer::kCenterX], dormer[param::dormer::kCenterY]));
  }
  for (const Rule& chimney : house.chimneys) {
    answer->chimneys.push_back(
        to_crop(chimney[param::chimney::kCenterX], chimney[param::chimney::kCenterY]));
  }
  for (const Rule& garage : house.garages) answer->garages.push_back(garage_ring(garage, to_crop));
}

/// In [0, pi / 2), also where rounding would give pi / 2 itself.
double modulo_quarter(double angle) {
  const double rest = std::fmod(angle, kQuarter);
  const double positive = rest < 0.0 ? rest + kQuarter : rest;
  return positive < kQuarter ? positive : 0.0;
}

}  // namespace

HouseAnswer proposed_answer(const Building& building, const HeightImage& image) {
  HouseAnswer answer;
  answer.id = building.id;
  const double azimuth = building.house
                             ? building.house->azimuth[0]
                             : azimuth_candidates(image, kAzimuthSeparation).front().azimuth;
  const HouseCrop crop = make_house_crop(image, modulo_quarter(azimuth));
  answer.frame.azimuth = crop.azimuth;
  answer.frame.pixel = crop.pixel;
  answer.frame.north_west =
      image.origin.head<2>() + Eigen::Rotation2Dd(crop.azimuth) * crop.north_west;
  if (building.house) {
    propose_house(*building.house, &answer);
  } else {
    for (const Eigen::Vector2d& p : building.outline.outer) {
      answer.polygon.push_back(answer.frame.crop_from_world(building.origin.head<2>() + p));
    }
  }
  answer.proposed = foundation_name(answer.foundation);
  return answer;
}

}  // namespace gable
