#include <gable/grammar/synthesis/houses/plain_house.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/random_garage.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLeastCells = 4.5;  // of the width of what is smallest

double plain_pitch(Random* random) {
  return std::clamp(37.0 + random->normal(8.0), 18.0, 55.0) * kDegree;
}

RoofEnd random_end(double hip_share, Random* random) {
  return random->chance(hip_share) ? RoofEnd::kHip : RoofEnd::kGable;
}

Rule plain_roof(PlainKind kind, const Rectangle& r, Random* random) {
  if (kind == PlainKind::kOuthouse) {
    if (random->chance(0.55)) return make_flat_roof(random->uniform(2.1, 3.5));
    return make_roof(r, Axis::kX, random->uniform(1.9, 2.7), plain_pitch(random), RoofEnd::kGable,
                     RoofEnd::kGable, random);
  }
  const double eaves =
      kind == PlainKind::kTerrace ? random->uniform(3.5, 6.5) : random_eaves(random);
  if (random->chance(0.03)) return make_flat_roof(std::max(3.0, eaves));
  const bool across =
      kind == PlainKind::kHouse && r.size_x() < 1.3 * r.size_y() && random->chance(0.25);
  const bool hipped = random->chance(0.2);
  const RoofEnd start = random_end(hipped ? 0.8 : 0.0, random);
  const RoofEnd end = random_end(hipped ? 0.8 : 0.0, random);
  return make_roof(r, across ? Axis::kY : Axis::kX, eaves, plain_pitch(random), start, end, random);
}

}  // namespace

House random_plain_house(PlainKind kind, double gsd, Random* random) {
  double width = random->uniform(6.0, 9.2), length = 0.0;
  if (kind == PlainKind::kHouse) length = std::max(width, 7.0 + 13.0 * random->uniform(0.0, 1.0));
  if (kind == PlainKind::kTerrace) length = random->uniform(20.0, 40.0);
  if (kind == PlainKind::kOuthouse) {
    width = std::max(kLeastCells * gsd, random->uniform(2.6, 4.5));
    length = std::max(width, random->uniform(3.0, 8.0));
  }
  const Rectangle r = {-0.5 * length, 0.5 * length, -0.5 * width, 0.5 * width};
  House house = make_house(Foundation::kI);
  using namespace param::rectangle;
  house.footprints[0][kCenterX] = house.footprints[0][kCenterY] = 0.0;
  house.footprints[0][kLength] = length;
  house.footprints[0][kWidth] = width;
  house.roofs[0] = plain_roof(kind, r, random);
  house.azimuth[0] = random->uniform(0.0, 2.0 * M_PI);
  if (kind == PlainKind::kOuthouse) return house;
  if (random->chance(0.4)) add_chimneys(random, &house);
  if (random->chance(0.35)) add_garages(random, &house);
  return house;
}

void tilt_flat_roof(Random* random, BuiltShape* shape) {
  assert(shape->parts.size() == 1);
  BuiltPart& part = shape->parts[0];
  if (part.form != PartForm::kFlat) return;
  const Eigen::Vector2d across(-part.along.y(), part.along.x());
  if (random->chance(0.5)) {
    part.along = across;
    std::swap(part.half_length, part.half_width);
  }
  part.form = PartForm::kMono;
  part.rise = 2.0 * part.half_width * std::tan(random->uniform(4.0, 14.0) * kDegree);
  part.eaves -= 0.5 * part.rise;
}

}  // namespace gable
