#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace gable {
namespace {

constexpr double kTouch = 1e-6;
constexpr double kVisibleArea = 12.0;
constexpr double kWingReach = 2.0;
constexpr double kSharedEaves = 0.3;

double eaves_of(const Rule& roof) { return roof[param::roof::kEaves]; }

double top_of(const Rule& roof) {
  return roof.kind == RuleKind::kRoofFlat ? eaves_of(roof)
                                          : eaves_of(roof) + roof[param::roof::kRise];
}

/// Whether [b0, b1] ends inside or outside [a0, a1] by a step at both ends.
bool steps_at_both_ends(double a0, double a1, double b0, double b1) {
  return std::abs(a0 - b0) >= kDistinctStep && std::abs(a1 - b1) >= kDistinctStep;
}

bool steps_in_plan(const Rectangle& a, const Rectangle& b) {
  // The blocks meet across the axis along which they overlap least.
  const double overlap_x = std::min(a.x1, b.x1) - std::max(a.x0, b.x0);
  const double overlap_y = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
  return overlap_x < overlap_y ? steps_at_both_ends(a.y0, a.y1, b.y0, b.y1)
                               : steps_at_both_ends(a.x0, a.x1, b.x0, b.x1);
}

bool pair_is_distinct(const Rectangle& a, const Rule& roof_a, const Rectangle& b,
                      const Rule& roof_b) {
  const double shared = shared_area(a, b);
  if (a.area() - shared < kVisibleArea || b.area() - shared < kVisibleArea) return false;
  return steps_in_plan(a, b) || (std::abs(eaves_of(roof_a) - eaves_of(roof_b)) >= kDistinctStep &&
                                 std::abs(top_of(roof_a) - top_of(roof_b)) >= kDistinctStep);
}

bool free_blocks_are_distinct(const House& house, const std::vector<Rectangle>& rectangles) {
  const int n = house.num_components();
  std::vector<int> body(n);
  std::iota(body.begin(), body.end(), 0);
  for (int i = 0; i < n; ++i) {
    const Rule& roof = house.roofs[i];
    if (roof.kind == RuleKind::kRoofFlat && eaves_of(roof) < kFlatBlockHeight) return false;
    for (int j = 0; j < i; ++j) {
      if (distance(rectangles[i], rectangles[j]) > kTouch) continue;
      if (!pair_is_distinct(rectangles[i], roof, rectangles[j], house.roofs[j])) return false;
      const int from = body[i];
      const int to = body[j];
      for (int& b : body) b = b == from ? to : b;
    }
  }
  for (int b : body) {
    if (b != body[0]) return false;
  }
  return true;
}

bool wings_are_distinct(const House& house) {
  const Rule& footprint = house.footprints[0];
  for (const Rule& roof : house.roofs) {
    if (std::abs(eaves_of(roof) - eaves_of(house.roofs[0])) > kSharedEaves) return false;
  }
  if (house.foundation == Foundation::kL) {
    using namespace param::l_polygon;
    return footprint[kWingXLength] - footprint[kWingYWidth] >= kWingReach &&
           footprint[kWingYLength] - footprint[kWingXWidth] >= kWingReach;
  }
  using namespace param::u_polygon;
  const double between = footprint[kBaseLength] - footprint[kLeftWidth] - footprint[kRightWidth];
  return between >= kWingReach && footprint[kLeftLength] - footprint[kBaseWidth] >= kWingReach &&
         footprint[kRightLength] - footprint[kBaseWidth] >= kWingReach;
}

}  // namespace

bool is_distinct(const House& house) {
  if (house.foundation == Foundation::kI) return true;
  if (house.foundation == Foundation::kL || house.foundation == Foundation::kU) {
    return wings_are_distinct(house);
  }
  std::vector<Rectangle> rectangles;
  for (const Block<double>& block : expand_blocks(house)) {
    rectangles.push_back(rectangle_of(block));
  }
  rectangles.resize(house.num_components());
  return free_blocks_are_distinct(house, rectangles);
}

}  // namespace gable
