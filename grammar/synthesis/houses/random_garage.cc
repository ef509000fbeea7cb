#include <gable/grammar/synthesis/houses/random_garage.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <vector>

namespace gable {
namespace {

constexpr double kBelowEaves = 0.4;
constexpr double kLowest = 2.2;
constexpr double kHighest = 3.2;

std::vector<Rectangle> component_and_garage_rectangles(const House& house) {
  std::vector<Rectangle> rectangles;
  const auto sources = block_sources(house);
  const auto blocks = expand_blocks(house);
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (sources[i].role == BlockRole::kComponent || sources[i].role == BlockRole::kGarage) {
      rectangles.push_back(rectangle_of(blocks[i]));
    }
  }
  return rectangles;
}

double contact(double a0, double a1, double b0, double b1) {
  return std::max(0.0, std::min(a1, b1) - std::max(a0, b0));
}

/// Where a side of length `side` may start along a wall so that more than half of it touches.
double draw_start(double wall0, double wall1, double side, Random* random) {
  if (random->chance(0.4)) return random->chance(0.5) ? wall0 : wall1 - side;  // flush
  return random->uniform(wall0 - 0.45 * side, wall1 - 0.55 * side);
}

bool is_free(const Rectangle& r, const std::vector<Rectangle>& others) {
  return std::all_of(others.begin(), others.end(),
                     [&](const Rectangle& other) { return shared_area(r, other) <= 1e-9; });
}

bool draw_rectangular(const Rectangle& wall, const std::vector<Rectangle>& others, Random* random,
                      Rule* garage) {
  const bool two_cars = random->chance(0.25);
  double size_x = two_cars ? random->uniform(5.0, 6.0) : random->uniform(2.7, 3.5);
  double size_y = random->uniform(5.0, 7.0);
  if (random->chance(0.5)) std::swap(size_x, size_y);
  Rectangle r;
  const int side = random->integer(0, 3);
  double touching;
  if (side < 2) {
    r.x0 = side == 0 ? wall.x1 : wall.x0 - size_x;
    r.y0 = draw_start(wall.y0, wall.y1, size_y, random);
    touching = contact(r.y0, r.y0 + size_y, wall.y0, wall.y1) / size_y;
  } else {
    r.y0 = side == 2 ? wall.y1 : wall.y0 - size_y;
    r.x0 = draw_start(wall.x0, wall.x1, size_x, random);
    touching = contact(r.x0, r.x0 + size_x, wall.x0, wall.x1) / size_x;
  }
  r.x1 = r.x0 + size_x;
  r.y1 = r.y0 + size_y;
  if (touching <= 0.5 || !is_free(r, others)) return false;
  using namespace param::rectangle;
  *garage = make_rule(RuleKind::kGarageI);
  (*garage)[kCenterX] = r.mid_x();
  (*garage)[kCenterY] = r.mid_y();
  (*garage)[kLength] = size_x;
  (*garage)[kWidth] = size_y;
  return true;
}

/// An L whose corner lies to the lower left: its back against a wall to its left or below it, or
/// wrapped around the lower left corner of a component.
bool draw_l_shaped(const Rectangle& wall, const std::vector<Rectangle>& others, Random* random,
                   Rule* garage) {
  using namespace param::l_polygon;
  const double width_x = random->uniform(2.6, 3.4);
  const double width_y = random->uniform(2.6, 3.4);
  const double length_x = width_y + random->uniform(2.0, 4.0);
  const double length_y = width_x + random->uniform(2.0, 4.0);
  double x = 0.0, y = 0.0, touching = 0.0;
  const int placement = random->integer(0, 2);
  if (placement == 0) {
    x = wall.x1;
    y = draw_start(wall.y0, wall.y1, length_y, random);
    touching = contact(y, y + length_y, wall.y0, wall.y1) / length_y;
  } else if (placement == 1) {
    x = draw_start(wall.x0, wall.x1, length_x, random);
    y = wall.y1;
    touching = contact(x, x + length_x, wall.x0, wall.x1) / length_x;
  } else {
    x = wall.x0 - width_y;
    y = wall.y0 - width_x;
    touching = contact(wall.x0, x + length_x, wall.x0, wall.x1) / (length_x - width_y);
  }
  const Rectangle wing_x = {x, x + length_x, y, y + width_x};
  const Rectangle wing_y = {x, x + width_y, y, y + length_y};
  if (touching <= 0.5 || !is_free(wing_x, others) || !is_free(wing_y, others)) return false;
  *garage = make_rule(RuleKind::kGarageL);
  (*garage)[kCornerX] = x;
  (*garage)[kCornerY] = y;
  (*garage)[kWingXLength] = length_x;
  (*garage)[kWingXWidth] = width_x;
  (*garage)[kWingYLength] = length_y;
  (*garage)[kWingYWidth] = width_y;
  return true;
}

bool add_garage(Random* random, House* house) {
  const std::vector<Rectangle> others = component_and_garage_rectangles(*house);
  const int component = random->integer(0, house->num_components() - 1);
  double lowest_eaves = kHighest + kBelowEaves;
  for (const Rule& roof : house->roofs) {
    lowest_eaves = std::min(lowest_eaves, roof[param::roof::kEaves]);
  }
  const double highest = std::min(kHighest, lowest_eaves - kBelowEaves);
  if (highest < kLowest) return false;
  const bool l_shaped = random->chance(0.2);
  Rule garage;
  const Rectangle& wall = others[component];
  if (!(l_shaped ? draw_l_shaped(wall, others, random, &garage)
                 : draw_rectangular(wall, others, random, &garage))) {
    return false;
  }
  garage[l_shaped ? param::garage::kHeightL : param::garage::kHeightI] =
      random->uniform(kLowest, highest);
  house->garages.push_back(garage);
  return true;
}

}  // namespace

void add_garages(Random* random, House* house) {
  const size_t wanted = random->chance(0.85) ? 1 : 2;
  for (int attempt = 0; attempt < 20 && house->garages.size() < wanted; ++attempt) {
    add_garage(random, house);
  }
}

}  // namespace gable
