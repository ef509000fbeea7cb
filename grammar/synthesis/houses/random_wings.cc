#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/random_wings.h>

#include <cmath>

namespace gable {
namespace {

/// What the roofs do where two wings meet.
enum class Corner { kMitred, kFirstThrough, kSecondThrough, kBothGabled };

Corner random_corner(Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.55) return Corner::kMitred;
  if (kind < 0.75) return Corner::kFirstThrough;
  if (kind < 0.95) return Corner::kSecondThrough;
  return Corner::kBothGabled;
}

bool first_is_hipped(Corner corner) {
  return corner == Corner::kMitred || corner == Corner::kSecondThrough;
}

bool second_is_hipped(Corner corner) {
  return corner == Corner::kMitred || corner == Corner::kFirstThrough;
}

/// Ratio of a hip as steep as the sides of a wing.
double mitre(double length, double width) { return 0.5 * width / length; }

double free_end(double length, double width, Random* random) {
  if (random->chance(0.55)) return 0.0;
  return mitre(length, width) * (random->chance(0.6) ? 1.0 : random->uniform(0.75, 1.0));
}

Rule wing_roof(Axis ridge, double eaves, double width, double pitch, double start, double end) {
  namespace r = param::roof;
  const bool gables = start == 0.0 && end == 0.0;
  Rule roof = make_rule(gables ? RuleKind::kRoofGable : RuleKind::kRoofHip);
  roof.ridge = ridge;
  roof[r::kEaves] = eaves;
  roof[r::kRise] = 0.5 * width * std::tan(pitch);
  if (!gables) {
    roof[r::kHipStart] = start;
    roof[r::kHipEnd] = end;
  }
  return roof;
}

/// Eaves of a wing beside one with the given eaves: mostly the same.
double shared_eaves(double eaves, Random* random) {
  return random->chance(0.9) ? eaves : eaves - random->uniform(0.0, 0.3);
}

/// Width of a wing beside one with the given width: the same in half of the houses.
double shared_width(double width, double low, double high, Random* random) {
  return random->chance(0.5) ? width : random->uniform(low, high);
}

}  // namespace

House random_l(Random* random) {
  using namespace param::l_polygon;
  House house = make_house(Foundation::kL);
  const double width_x = random->uniform(4.8, 8.0);
  const double width_y = shared_width(width_x, 4.5, 8.0, random);
  const double length_x = width_y + random->uniform(2.5, 9.0);
  const double length_y = width_x + random->uniform(2.5, 8.0);
  Rule& polygon = house.footprints[0];
  polygon[kCornerX] = 0.0;
  polygon[kCornerY] = 0.0;
  polygon[kWingXLength] = length_x;
  polygon[kWingXWidth] = width_x;
  polygon[kWingYLength] = length_y;
  polygon[kWingYWidth] = width_y;

  const double eaves = random_eaves(random);
  const double pitch = random_pitch(random);
  // A hip at the corner needs its run within half of the wing.
  const bool long_enough = length_x >= width_x && length_y >= width_y;
  const Corner corner = long_enough ? random_corner(random) : Corner::kBothGabled;
  const double start_x = first_is_hipped(corner) ? mitre(length_x, width_x) : 0.0;
  const double start_y = second_is_hipped(corner) ? mitre(length_y, width_y) : 0.0;
  const double end_x = long_enough ? free_end(length_x, width_x, random) : 0.0;
  const double end_y = long_enough ? free_end(length_y, width_y, random) : 0.0;
  house.roofs[0] = wing_roof(Axis::kX, eaves, width_x, pitch, start_x, end_x);
  house.roofs[1] = wing_roof(Axis::kY, shared_eaves(eaves, random), width_y, pitch, start_y, end_y);
  return house;
}

House random_u(Random* random) {
  using namespace param::u_polygon;
  House house = make_house(Foundation::kU);
  const double base_width = random->uniform(4.8, 7.5);
  const double left_width = shared_width(base_width, 4.2, 6.5, random);
  const bool symmetric = random->chance(0.4);
  const double right_width = symmetric ? left_width : shared_width(left_width, 4.2, 6.5, random);
  const double left_reach = random->uniform(2.5, 7.0);
  const double right_reach = symmetric ? left_reach : random->uniform(2.5, 7.0);
  const double base_length = left_width + right_width + random->uniform(2.5, 8.0);
  const double left_length = base_width + left_reach;
  const double right_length = base_width + right_reach;
  Rule& polygon = house.footprints[0];
  polygon[kCornerX] = 0.0;
  polygon[kCornerY] = 0.0;
  polygon[kBaseLength] = base_length;
  polygon[kBaseWidth] = base_width;
  polygon[kLeftLength] = left_length;
  polygon[kLeftWidth] = left_width;
  polygon[kRightLength] = right_length;
  polygon[kRightWidth] = right_width;

  const double eaves = random_eaves(random);
  const double pitch = random_pitch(random);
  const Corner left_corner = random_corner(random);
  const Corner right_corner = random->chance(0.8) ? left_corner : random_corner(random);
  const auto base_end = [&](Corner corner) {
    return first_is_hipped(corner) ? mitre(base_length, base_width) : 0.0;
  };
  const auto wing = [&](Corner corner, double length, double width, double end) {
    const double start = second_is_hipped(corner) ? mitre(length, width) : 0.0;
    return wing_roof(Axis::kY, shared_eaves(eaves, random), width, pitch, start, end);
  };
  const double left_end = free_end(left_length, left_width, random);
  const double right_end = symmetric ? left_end : free_end(right_length, right_width, random);
  house.roofs[0] =
      wing_roof(Axis::kX, eaves, base_width, pitch, base_end(left_corner), base_end(right_corner));
  house.roofs[1] = wing(left_corner, left_length, left_width, left_end);
  house.roofs[2] = wing(right_corner, right_length, right_width, right_end);
  return house;
}

}  // namespace gable
