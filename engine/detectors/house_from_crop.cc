#include <gable/engine/detectors/component_heights.h>
#include <gable/engine/detectors/house_from_crop.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/wing_polygons.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gable {
namespace {

constexpr double kLeastHouse = 2.0;           // metres over the terrain (NPR section 5.1)
constexpr double kLeastGarage = 0.5;          // metres over the terrain
constexpr double kChimneyOverRoof = 2.5;      // metres (NPR section 4.3)
constexpr double kMostChimneyDistance = 1.0;  // from the wall, metres
constexpr double kMostDormerOverRoof = 2.0;   // its eaves over the roof at its centre, metres

void clamp_to_bounds(Rule* rule) {
  const auto specs = parameter_specs(rule->kind);
  for (size_t i = 0; i < specs.size(); ++i) {
    rule->values[i] = std::clamp(rule->values[i], specs[i].lower, specs[i].upper);
  }
}

Eigen::Vector2d turned(const Eigen::Vector2d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

// Points and rectangles of a crop in the frame of the crop's azimuth or in a house's own.
class CropToHouse {
 public:
  CropToHouse(const HouseCrop& crop, double azimuth) : crop_(crop), turn_(crop.azimuth - azimuth) {}

  Eigen::Vector2d point(const Eigen::Vector2d& crop) const {
    return turned(crop_.house_from_crop(crop), turn_);
  }
  Eigen::Vector2d local(const Eigen::Vector2d& crop) const {
    return turned(crop_.house_from_crop(crop), crop_.azimuth);
  }
  Eigen::Vector2d direction(const Eigen::Vector2d& house) const { return turned(house, turn_); }

  // The turn is one by quarters.
  RoofedRectangle rectangle(const CropRectangle& r) const {
    const Eigen::Vector2d a = point({r.x0, r.y0}), b = point({r.x1, r.y1});
    return {std::min(a.x(), b.x()), std::max(a.x(), b.x()), std::min(a.y(), b.y()),
            std::max(a.y(), b.y()), Rule()};
  }

 private:
  const HouseCrop& crop_;
  double turn_;
};

std::optional<ComponentHeights> heights_over(const RoofedRectangle& r, double azimuth,
                                             const HeightImage& image, double least_height) {
  return component_heights(image, {azimuth, r.x0, r.x1, r.y0, r.y1}, least_height);
}

Rule make_roof(RoofType type, Axis ridge, const std::optional<ComponentHeights>& heights) {
  Rule roof = make_rule(type == RoofType::kFlat    ? RuleKind::kRoofFlat
                        : type == RoofType::kGable ? RuleKind::kRoofGable
                                                   : RuleKind::kRoofHip);
  roof.ridge = ridge;
  if (!heights) return roof;
  if (type == RoofType::kFlat) {
    roof[param::roof::kEaves] = heights->middle;
  } else {
    roof[param::roof::kEaves] = heights->eaves;
    roof[param::roof::kRise] = heights->top - heights->eaves;
  }
  clamp_to_bounds(&roof);
  return roof;
}

House bare_house(const HouseCrop& crop, const CropFoundation& foundation,
                 const std::vector<RoofType>& roofs, const HeightImage& image) {
  const CropToHouse frame(crop, crop.azimuth);
  const bool is_polygon =
      foundation.foundation == Foundation::kL || foundation.foundation == Foundation::kU;
  // An L's first rectangle runs along x, a U's along its closed side; the others across.
  const bool first_along_x = foundation.side.y() != 0.0;
  std::vector<RoofedRectangle> rectangles;
  for (size_t i = 0; i < foundation.rectangles.size(); ++i) {
    RoofedRectangle r = frame.rectangle(foundation.rectangles[i]);
    const Axis ridge = !is_polygon                 ? ridge_axis(crop, foundation.rectangles[i])
                       : (i == 0) == first_along_x ? Axis::kX
                                                   : Axis::kY;
    r.roof = make_roof(roofs[is_polygon ? 0 : i], ridge,
                       heights_over(r, crop.azimuth, image, kLeastHouse));
    rectangles.push_back(r);
  }
  House house =
      foundation.foundation == Foundation::kL
          ? l_house(rectangles[0], rectangles[1], foundation.side, crop.azimuth)
      : foundation.foundation == Foundation::kU
          ? u_house(rectangles[0], rectangles[1], rectangles[2], foundation.side, crop.azimuth)
          : blocks_house(rectangles, crop.azimuth);
  house.origin = image.origin;
  for (Rule& footprint : house.footprints) clamp_to_bounds(&footprint);
  return house;
}

bool contains(const Block<double>& b, const Eigen::Vector2d& p) {
  using namespace block_value;
  return p.x() >= b[kX0] && p.x() <= b[kX1] && p.y() >= b[kY0] && p.y() <= b[kY1];
}

// The component whose roof is seen from above at a point that is at most `distance` metres away
// from it, and the height of that roof at the point of the component that is nearest.
struct RoofBelow {
  int component = -1;
  double height = 0.0;
};

RoofBelow roof_below(const std::vector<Block<double>>& components, const Eigen::Vector2d& point,
                     double distance) {
  using namespace block_value;
  RoofBelow best;
  bool best_contains = false;
  for (size_t i = 0; i < components.size(); ++i) {
    const Block<double>& b = components[i];
    const Eigen::Vector2d nearest(std::clamp(point.x(), b[kX0], b[kX1]),
                                  std::clamp(point.y(), b[kY0], b[kY1]));
    if ((nearest - point).norm() > distance) continue;
    const bool over = contains(b, point);
    const double height = roof_height(b, nearest.x(), nearest.y());
    if (best.component >= 0 && (over == best_contains ? height <= best.height : best_contains)) {
      continue;
    }
    best = {static_cast<int>(i), height};
    best_contains = over;
  }
  return best;
}

void add_dormers(const std::vector<Peak>& peaks, const CropToHouse& frame,
                 const std::vector<Block<double>>& components, const HeightImage& image,
                 House* house) {
  for (const Peak& peak : peaks) {
    const Eigen::Vector2d center = frame.point(peak.crop);
    const RoofBelow roof = roof_below(components, center, 0.0);
    if (roof.component < 0) continue;
    namespace d = param::dormer;
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = roof.component;
    dormer[d::kCenterX] = center.x();
    dormer[d::kCenterY] = center.y();
    // The ridge of the dormer is over its centre, the median over the pixels around lies halfway.
    const double seen = height_near(image, frame.local(peak.crop)).value_or(roof.height);
    dormer[d::kEaves] =
        std::clamp(seen, roof.height, roof.height + kMostDormerOverRoof) - 0.5 * dormer[d::kRise];
    clamp_to_bounds(&dormer);
    house->dormers.push_back(dormer);
  }
}

void add_chimneys(const std::vector<Peak>& peaks, const CropToHouse& frame,
                  const std::vector<Block<double>>& components, House* house) {
  for (const Peak& peak : peaks) {
    const Eigen::Vector2d center = frame.point(peak.crop);
    const RoofBelow roof = roof_below(components, center, kMostChimneyDistance);
    if (roof.component < 0) continue;
    namespace c = param::chimney;
    Rule chimney = make_rule(RuleKind::kChimney);
    chimney[c::kCenterX] = center.x();
    chimney[c::kCenterY] = center.y();
    chimney[c::kHeight] = roof.height + kChimneyOverRoof;
    clamp_to_bounds(&chimney);
    house->chimneys.push_back(chimney);
  }
}

Rule rectangle_garage(const RoofedRectangle& r, double azimuth, const HeightImage& image) {
  namespace g = param::rectangle;
  Rule garage = make_rule(RuleKind::kGarageI);
  garage[g::kCenterX] = 0.5 * (r.x0 + r.x1);
  garage[g::kCenterY] = 0.5 * (r.y0 + r.y1);
  garage[g::kLength] = r.x1 - r.x0;
  garage[g::kWidth] = r.y1 - r.y0;
  if (const auto heights = heights_over(r, azimuth, image, kLeastGarage)) {
    garage[param::garage::kHeightI] = heights->middle;
  }
  clamp_to_bounds(&garage);
  return garage;
}

void add_garage(const CropGarage& crop_garage, const CropToHouse& frame, const HeightImage& image,
                House* house) {
  const double azimuth = house->azimuth[0];
  RoofedRectangle x = frame.rectangle(crop_garage.rectangles[0]);
  if (crop_garage.rectangles.size() == 1) {
    house->garages.push_back(rectangle_garage(x, azimuth, image));
    return;
  }
  RoofedRectangle y = frame.rectangle(crop_garage.rectangles[1]);
  if (x.x1 - x.x0 < y.x1 - y.x0) std::swap(x, y);  // a quarter turn swaps them
  const Eigen::Vector2d corner = frame.direction(crop_garage.side);
  if (corner.x() < 0.0 && corner.y() < 0.0) {
    namespace l = param::l_polygon;
    Rule garage = make_rule(RuleKind::kGarageL);
    garage[l::kCornerX] = x.x0;
    garage[l::kCornerY] = x.y0;
    garage[l::kWingXLength] = x.x1 - x.x0;
    garage[l::kWingXWidth] = x.y1 - x.y0;
    garage[l::kWingYLength] = y.y1 - y.y0;
    garage[l::kWingYWidth] = y.x1 - y.x0;
    if (const auto heights = heights_over(x, azimuth, image, kLeastGarage)) {
      garage[param::garage::kHeightL] = heights->middle;
    }
    clamp_to_bounds(&garage);
    house->garages.push_back(garage);
    return;
  }
  (corner.y() < 0.0 ? y.y0 : y.y1) = corner.y() < 0.0 ? x.y1 : x.y0;
  house->garages.push_back(rectangle_garage(x, azimuth, image));
  house->garages.push_back(rectangle_garage(y, azimuth, image));
}

}  // namespace

Axis ridge_axis(const HouseCrop& crop, const CropRectangle& rectangle) {
  constexpr double kLeast = 0.17;  // of a normal's horizontal part: a pitch of 10 degrees
  constexpr double kClear = 1.5;   // how many times as many pixels decide
  constexpr int kFew = 12;         // pixels that decide nothing
  const CropBits pixels = bits_of(rectangle) & mask_bits(crop);
  int leans_x = 0, leans_y = 0;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (!pixels.at(row, col)) continue;
      const double x = std::abs(crop.at(CropChannel::kNormalX, row, col) / 127.5 - 1.0);
      const double y = std::abs(crop.at(CropChannel::kNormalY, row, col) / 127.5 - 1.0);
      // Walls lean across their edge whatever the roof does.
      if (crop.at(CropChannel::kNormalZ, row, col) < 255 / 2) continue;
      if (std::max(x, y) < kLeast) continue;
      ++(x > y ? leans_x : leans_y);
    }
  }
  if (leans_x + leans_y >= kFew) {
    if (leans_y > kClear * leans_x) return Axis::kX;
    if (leans_x > kClear * leans_y) return Axis::kY;
  }
  return rectangle.width() >= rectangle.height() ? Axis::kX : Axis::kY;
}

House house_from_crop(const HouseCrop& crop, const CropFoundation& foundation,
                      const CropDetails& details, const HeightImage& image) {
  const bool is_polygon =
      foundation.foundation == Foundation::kL || foundation.foundation == Foundation::kU;
  CHECK_EQ(static_cast<int>(foundation.rectangles.size()), num_components(foundation.foundation));
  CHECK_EQ(details.roofs.size(), is_polygon ? 1 : foundation.rectangles.size());
  House house = bare_house(crop, foundation, details.roofs, image);
  const CropToHouse frame(crop, house.azimuth[0]);
  const std::vector<Block<double>> components = expand_blocks(house);
  add_dormers(details.dormers, frame, components, image, &house);
  add_chimneys(details.chimneys, frame, components, &house);
  for (const CropGarage& garage : details.garages) add_garage(garage, frame, image, &house);
  CHECK(is_well_formed(house));
  return house;
}

}  // namespace gable
