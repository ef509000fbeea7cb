#include <gable/grammar/block.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/box_dormers.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/flat_parts.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/row_house.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLeastCells = 7.0;       // of the width
constexpr double kLeastShelfCells = 3.5;  // of the depth of a flat part
constexpr double kLeastShelf = 1.8;       // metres
constexpr double kShelfBelow = 1.5;       // the ridge, metres

Rule footprint_over(const Rectangle& r) {
  using namespace param::rectangle;
  Rule footprint = make_rule(RuleKind::kFootprintI);
  footprint[kCenterX] = r.mid_x();
  footprint[kCenterY] = r.mid_y();
  footprint[kLength] = r.size_x();
  footprint[kWidth] = r.size_y();
  return footprint;
}

void add_component(const Rectangle& r, const Rule& roof, House* house) {
  house->footprints.push_back(footprint_over(r));
  house->roofs.push_back(roof);
}

double row_width(double gsd, Random* random) {
  const double width = random->chance(0.7) ? random->uniform(4.0, 6.0) : random->uniform(5.5, 8.0);
  return std::max(width, kLeastCells * gsd);
}

double row_eaves(Foundation foundation, Random* random) {
  // Flat parts of more than a garage's height need room under the eaves.
  if (foundation != Foundation::kI || random->chance(0.7)) return random->uniform(4.8, 7.5);
  return random->uniform(2.6, 4.8);
}

Rule row_roof(const Rectangle& r, double eaves, Random* random) {
  const double pitch = std::clamp(40.0 + random->normal(8.0), 22.0, 58.0) * kDegree;
  if (random->chance(0.65)) {
    return make_roof(r, Axis::kX, eaves, pitch, RoofEnd::kGable, RoofEnd::kGable, random);
  }
  const RoofEnd front = random->chance(0.55) ? RoofEnd::kHip : RoofEnd::kGable;
  const RoofEnd back = random->chance(0.25) ? RoofEnd::kHip : RoofEnd::kGable;
  return make_roof(r, Axis::kY, eaves, pitch, front, back, random);
}

/// A flat part as wide as the house behind the ridge, at `height` or a step below it.
Rectangle shelf_behind(const Rectangle& main, const Rule& roof, double height, double least_depth,
                       Random* random) {
  namespace r = param::roof;
  // It starts where the back slope comes down to its height.
  double from = main.y1;
  if (roof.kind == RuleKind::kRoofGable && roof.ridge == Axis::kX && roof[r::kRise] > 0.0) {
    from -= (height - roof[r::kEaves]) / roof[r::kRise] * 0.5 * main.size_y();
  }
  const double depth = std::max(least_depth, random->uniform(1.8, 4.0));
  return {main.x0, main.x1, from, std::max(main.y1, from + depth)};
}

House draw(Foundation foundation, double gsd, Random* random) {
  House house;
  house.foundation = foundation;
  const double width = row_width(gsd, random);
  const Rectangle main = {0.0, width, 0.0, random->uniform(6.5, 11.0)};
  const double eaves = row_eaves(foundation, random);
  const bool flat = random->chance(foundation == Foundation::kI ? 0.12 : 0.2);
  const Rule roof = flat ? make_flat_roof(eaves + 1.0) : row_roof(main, eaves, random);
  add_component(main, roof, &house);
  const int parts = num_components(foundation) - 1;
  const double least_depth = std::max(kLeastShelf, kLeastShelfCells * gsd);
  const bool along = !flat && roof.ridge == Axis::kX;
  double height = flat ? eaves + 1.0 - random->uniform(1.1, 3.0) : eaves;
  double back = main.y1;
  for (int i = 0; i < parts; ++i) {
    Rectangle part;
    if (i == 0 && along && random->chance(0.7)) {
      const double rise = roof[param::roof::kRise];
      if (random->chance(0.5)) height += random->uniform(0.0, std::max(0.0, rise - kShelfBelow));
      part = shelf_behind(main, roof, height, least_depth, random);
    } else {
      if (i > 0 || !flat) height -= random->uniform(1.1, 2.6);
      const double depth = std::max(least_depth, random->uniform(2.0, 6.0));
      const double along_row =
          random->chance(0.65) ? width : std::max(2.4, width * random->uniform(0.45, 0.8));
      const double x0 = random->chance(0.5) ? 0.0 : width - along_row;
      part = {x0, x0 + along_row, back, back + depth};
    }
    back = part.y1;
    add_component(part, make_flat_roof(height), &house);
  }
  return house;
}

/// Low and flat at the back, as wide as the house or a strip along one party wall.
void add_back_extension(const Rectangle& last, double lowest, Random* random, House* house) {
  const double height = std::min(random->uniform(2.1, 3.4), lowest - 0.8);
  if (height < 2.1) return;
  const bool full = random->chance(0.5);
  const double along = full ? last.size_x() : std::min(last.size_x(), random->uniform(2.0, 3.4));
  const double x0 = random->chance(0.5) ? last.x0 : last.x1 - along;
  Rule garage = make_rule(RuleKind::kGarageI);
  const Rectangle at = {x0, x0 + along, last.y1, last.y1 + random->uniform(2.0, 6.0)};
  const Rule footprint = footprint_over(at);
  for (int i = 0; i < footprint.size(); ++i) garage[i] = footprint[i];
  garage[param::garage::kHeightI] = height;
  house->garages.push_back(garage);
}

/// A stack against a party wall.
void add_party_chimney(const Rectangle& main, Random* random, House* house) {
  const double side = random->uniform(0.5, 1.2);
  const double inset = 0.5 * side + 0.02;
  const bool at_ridge = random->chance(0.6);
  const Eigen::Vector2d center(
      random->chance(0.5) ? main.x0 + inset : main.x1 - inset,
      at_ridge ? main.mid_y() : random->uniform(main.y0 + inset, main.y1 - inset));
  const HeightField field(*house);
  double highest = 0.0;
  for (double dx : {-0.5, 0.0, 0.5}) {
    for (double dy : {-0.5, 0.0, 0.5}) {
      highest =
          std::max(highest, field.at_house(center + side * Eigen::Vector2d(dx, dy), 0.0, 0.0));
    }
  }
  namespace c = param::chimney;
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney[c::kCenterX] = center.x();
  chimney[c::kCenterY] = center.y();
  chimney[c::kSide] = side;
  chimney[c::kHeight] = highest + random->uniform(0.9, 1.9);
  house->chimneys.push_back(chimney);
}

/// Moves everything so that the components' box is centred.
void center(House* house) {
  Rectangle box = rectangle_of(expand_blocks(*house)[0]);
  for (int i = 1; i < house->num_components(); ++i) {
    box = bounds(box, rectangle_of(expand_blocks(*house)[i]));
  }
  for (auto* rules : {&house->footprints, &house->dormers, &house->chimneys, &house->garages}) {
    for (Rule& rule : *rules) {
      rule[0] -= box.mid_x();
      rule[1] -= box.mid_y();
    }
  }
}

}  // namespace

House random_row_house(Foundation foundation, double gsd, Random* random) {
  assert(foundation == Foundation::kI || foundation == Foundation::kII ||
         foundation == Foundation::kIII);
  House house;
  do {
    house = draw(foundation, gsd, random);
  } while (!is_distinct(house) && !flat_parts_are_distinct(house));
  const auto blocks = expand_blocks(house);
  const Rectangle main = rectangle_of(blocks[0]);
  if (random->chance(0.35)) add_box_dormers(random, &house);
  if (house.dormers.empty() && random->chance(0.4)) add_party_chimney(main, random, &house);
  if (random->chance(0.45)) {
    const Rectangle last = rectangle_of(blocks[static_cast<size_t>(house.num_components()) - 1]);
    double lowest = house.roofs[0][param::roof::kEaves];
    for (const Rule& roof : house.roofs) lowest = std::min(lowest, roof[param::roof::kEaves]);
    add_back_extension(last, lowest, random, &house);
  }
  center(&house);
  house.azimuth[0] = random->uniform(0.0, 2.0 * M_PI);
  return house;
}

BuiltShape random_row_beside(const House& house, Random* random) {
  const Eigen::Vector2d x(std::cos(house.azimuth[0]), std::sin(house.azimuth[0]));
  const Eigen::Vector2d y(-x.y(), x.x());
  const double width = rectangle_of(expand_blocks(house)[0]).size_x();
  const int only = random->chance(0.2) ? (random->chance(0.5) ? 1 : -1) : 0;
  BuiltShape shape;
  for (int side : {-1, 1}) {
    if (only != 0 && side != only) continue;
    const double kind = random->uniform(0.0, 1.0);
    const double sign = random->chance(0.5) ? 1.0 : -1.0;
    const double up = kind < 0.5    ? 0.0
                      : kind < 0.85 ? sign * random->uniform(0.1, 0.6)
                                    : sign * random->uniform(0.6, 2.5);
    const double along_street =
        random->chance(0.6) ? 0.0 : random->uniform(0.3, 1.5) * (random->chance(0.5) ? 1.0 : -1.0);
    House other = house;
    if (random->chance(0.5)) other.dormers.clear();
    if (random->chance(0.6)) other.garages.clear();
    if (random->chance(0.5)) other.chimneys.clear();
    const Eigen::Vector2d by = side * width * x + along_street * y;
    other.origin += Eigen::Vector3d(by.x(), by.y(), up);
    shape.append(shape_of(other));
  }
  return shape;
}

}  // namespace gable
