#include <gable/grammar/synthesis/houses/complex_shapes.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLargest = 34.0;  // diagonal of the box around a shape, metres

double wide_pitch(Random* random) {
  return std::clamp(36.0 + random->normal(9.0), 15.0, 58.0) * kDegree;
}

double wide_eaves(Random* random) {
  return random->chance(0.15) ? random->uniform(6.5, 9.0) : random_eaves(random);
}

/// A part over a rectangle of its frame, ridge along u.
BuiltPart make_part(const Eigen::Vector2d& center, double azimuth, double length, double width,
                    PartForm form, double eaves, double rise) {
  BuiltPart part;
  part.center = center;
  part.along = {std::cos(azimuth), std::sin(azimuth)};
  part.half_length = 0.5 * length;
  part.half_width = 0.5 * width;
  part.form = form;
  part.eaves = eaves;
  part.rise = rise;
  return part;
}

BuiltPart make_gable(const Eigen::Vector2d& center, double azimuth, double length, double width,
                     double eaves, double pitch) {
  return make_part(center, azimuth, length, width, PartForm::kGable, eaves,
                   0.5 * width * std::tan(pitch));
}

/// The same over a rectangle of a frame at azimuth 0, ridge along x or y.
BuiltPart gable_over(const Rectangle& r, Axis ridge, double eaves, double pitch) {
  const Eigen::Vector2d center(r.mid_x(), r.mid_y());
  return ridge == Axis::kX ? make_gable(center, 0.0, r.size_x(), r.size_y(), eaves, pitch)
                           : make_gable(center, 0.5 * M_PI, r.size_y(), r.size_x(), eaves, pitch);
}

void turn(double angle, BuiltShape* shape) {
  Eigen::Matrix2d by;
  by << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  for (auto* list : {&shape->parts, &shape->lifts}) {
    for (BuiltPart& part : *list) {
      part.center = by * part.center;
      part.along = by * part.along;
    }
  }
}

/// Moves a shape so that the box around its parts' middles is around the origin, and turns it.
BuiltShape placed(BuiltShape shape, Random* random) {
  Eigen::Vector2d low = shape.parts[0].center, high = low;
  for (const BuiltPart& part : shape.parts) {
    low = low.cwiseMin(part.center);
    high = high.cwiseMax(part.center);
  }
  const Eigen::Vector2d middle = 0.5 * (low + high);
  shape.move({-middle.x(), -middle.y(), 0.0});
  turn(random->uniform(0.0, 2.0 * M_PI), &shape);
  return shape;
}

/// A block attached to one side of another, sliding along it; `under` of it lies within.
Rectangle attached(const Rectangle& to, Random* random) {
  const double depth = random->uniform(4.0, 8.0);
  const double along = random->uniform(4.0, 9.0);
  const double under = random->chance(0.5) ? 0.0 : random->uniform(0.0, 2.5);
  const int side = random->integer(0, 3);
  const double low = side < 2 ? to.y0 : to.x0;
  const double high = side < 2 ? to.y1 : to.x1;
  const double start = random->uniform(low - 0.4 * along, high - 0.6 * along);
  if (side == 0) return {to.x1 - under, to.x1 + depth, start, start + along};
  if (side == 1) return {to.x0 - depth, to.x0 + under, start, start + along};
  if (side == 2) return {start, start + along, to.y1 - under, to.y1 + depth};
  return {start, start + along, to.y0 - depth, to.y0 + under};
}

void add_block(const Rectangle& r, double eaves, bool flat, Random* random, House* house) {
  using namespace param::rectangle;
  Rule footprint = make_rule(RuleKind::kFootprintI);
  footprint[kCenterX] = r.mid_x();
  footprint[kCenterY] = r.mid_y();
  footprint[kLength] = r.size_x();
  footprint[kWidth] = r.size_y();
  house->footprints.push_back(footprint);
  const Axis ridge = r.size_x() > r.size_y() ? Axis::kX : Axis::kY;
  house->roofs.push_back(flat ? make_flat_roof(std::max(eaves, kFlatBlockHeight))
                              : random_roof(r, ridge, eaves, wide_pitch(random), random));
}

/// Wings at an angle grow out of the middle of the main block.
BuiltShape turned_wings(Random* random) {
  const double width = random->uniform(5.5, 9.0);
  const double length = width * random->uniform(1.0, 2.0);
  const double eaves = wide_eaves(random);
  const double pitch = wide_pitch(random);
  BuiltShape shape;
  shape.parts.push_back(make_gable({0.0, 0.0}, 0.0, length, width, eaves, pitch));
  const int wings = random->integer(1, 2);
  for (int i = 0; i < wings; ++i) {
    const double end = i == 0 ? 1.0 : -1.0;
    const double angle = random->uniform(20.0, 70.0) * kDegree * (random->chance(0.5) ? 1.0 : -1.0);
    const Eigen::Vector2d from(end * (0.5 * length - 0.4 * width), 0.0);
    const Eigen::Vector2d out = end * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double reach = 0.6 * width + random->uniform(5.0, 10.0);
    const double wing_width = random->chance(0.5) ? width : width * random->uniform(0.65, 1.0);
    const double wing_eaves = random->chance(0.6) ? eaves : eaves + random->uniform(-0.8, 0.6);
    BuiltPart wing = make_gable(from + 0.5 * reach * out, angle, reach, wing_width,
                                std::max(2.3, wing_eaves), pitch);
    if (random->chance(0.4)) (end > 0 ? wing.end_run : wing.start_run) = wing.half_width;
    shape.parts.push_back(wing);
  }
  return shape;
}

BuiltShape round_building(Random* random) {
  BuiltShape shape;
  const double eaves = random->uniform(2.6, 7.0);
  const bool alone = random->chance(0.6);
  const double radius = alone ? random->uniform(4.5, 11.0) : random->uniform(2.8, 4.5);
  const PartForm form = random->chance(0.7) ? PartForm::kCone : PartForm::kDome;
  const double rise = radius * (random->chance(0.15) ? 0.02 : random->uniform(0.25, 0.9));
  BuiltPart tower = make_part({0.0, 0.0}, random->uniform(0.0, M_PI), 2.0 * radius, 2.0 * radius,
                              form, eaves, rise);
  tower.count = random->chance(0.4) ? 0 : (random->chance(0.6) ? 8 : random->integer(5, 10));
  shape.parts.push_back(tower);
  if (alone) return shape;
  const double width = random->uniform(6.0, 9.0);
  const double length = width * random->uniform(1.1, 1.9);
  const double corner = random->chance(0.5) ? 0.5 * width : random->uniform(-0.3, 0.3) * width;
  shape.parts.push_back(make_gable({0.5 * length, corner}, 0.0, length, width,
                                   std::max(2.3, eaves - random->uniform(0.0, 1.5)),
                                   wide_pitch(random)));
  if (random->chance(0.5)) {
    shape.parts.push_back(make_gable({0.6 * length, corner + 0.5 * width}, 0.5 * M_PI, width + 4.0,
                                     0.7 * width, std::max(2.3, eaves - random->uniform(0.0, 2.0)),
                                     wide_pitch(random)));
  }
  return shape;
}

BuiltPart mansard_over(const Rectangle& r, double eaves, Random* random) {
  BuiltPart part = make_part({r.mid_x(), r.mid_y()}, 0.0, r.size_x(), r.size_y(),
                             PartForm::kMansard, eaves, 0.0);
  part.kink = random->uniform(1.4, 2.2);
  part.kink_rise = part.kink * std::tan(random->uniform(54.0, 66.0) * kDegree);
  const double upper = std::min(part.half_length, part.half_width) - part.kink;
  part.rise = part.kink_rise + upper * std::tan(random->uniform(2.0, 16.0) * kDegree);
  return part;
}

BuiltShape mansard(Random* random) {
  BuiltShape shape;
  const double width = random->uniform(8.5, 13.0);
  const double length = width * random->uniform(1.0, 1.9);
  const double eaves = random->uniform(3.0, 8.0);
  shape.parts.push_back(mansard_over({0.0, length, 0.0, width}, eaves, random));
  if (random->chance(0.5)) {  // a wing or a neighbour under the same roof
    const double wing = random->uniform(7.5, width);
    const double start = random->uniform(0.0, length - std::min(wing, length));
    shape.parts.push_back(mansard_over(
        {start, start + wing, 0.5 * width, width + random->uniform(4.0, 8.0)}, eaves, random));
  }
  return shape;
}

/// Boxes on a roof: machines, lights, hatches.
void add_machines(int count, double least, double most, Random* random, BuiltShape* shape) {
  const size_t parts = shape->parts.size();
  for (int i = 0; i < count; ++i) {
    const BuiltPart& roof =
        shape->parts[static_cast<size_t>(random->integer(0, static_cast<int>(parts) - 1))];
    const Eigen::Vector2d across(-roof.along.y(), roof.along.x());
    BuiltPart box = roof;
    box.form = PartForm::kFlat;
    box.half_length = random->uniform(0.4, 1.8);
    box.half_width = random->uniform(0.4, 1.4);
    box.center += random->uniform(-0.8, 0.8) * roof.half_length * roof.along +
                  random->uniform(-0.7, 0.7) * roof.half_width * across;
    box.eaves = random->uniform(least, most);
    shape->lifts.push_back(box);
  }
}

BuiltShape hall(Random* random) {
  BuiltShape shape;
  const double width = random->uniform(12.0, 17.0);
  const double length = std::min(28.0, width * random->uniform(1.2, 2.0));
  const double eaves = random->uniform(4.0, 8.0);
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.35) {
    BuiltPart part = make_part({0.0, 0.0}, 0.0, length, width, PartForm::kSawtooth, eaves,
                               random->uniform(1.6, 3.0));
    part.count = std::clamp(static_cast<int>(length / random->uniform(4.0, 7.0)), 3, 7);
    shape.parts.push_back(part);
  } else if (kind < 0.55) {
    shape.parts.push_back(make_part({0.0, 0.0}, 0.0, length, width, PartForm::kBarrel, eaves,
                                    width * random->uniform(0.22, 0.4)));
  } else if (kind < 0.85) {  // several roofs side by side
    const int bays = random->integer(4, 6);
    const double bay = std::clamp(length / bays, 4.0, 7.0);
    const double pitch = random->uniform(18.0, 42.0) * kDegree;
    const bool vaulted = random->chance(0.3);
    for (int i = 0; i < bays; ++i) {
      BuiltPart part = make_gable({i * bay, 0.0}, 0.5 * M_PI, width, bay, eaves, pitch);
      if (vaulted) part.form = PartForm::kBarrel;
      shape.parts.push_back(part);
    }
  } else {  // flat, with a higher and a lower part and a lot of machines
    shape.parts.push_back(make_part({0.0, 0.0}, 0.0, length, width, PartForm::kFlat, eaves, 0.0));
    shape.parts.push_back(make_part({0.25 * length, 0.1 * width}, 0.0, 0.3 * length, 0.4 * width,
                                    PartForm::kFlat, eaves + random->uniform(1.5, 4.0), 0.0));
    shape.parts.push_back(make_part({-0.6 * length, -0.2 * width}, 0.0, 0.3 * length, 0.5 * width,
                                    PartForm::kFlat, std::max(2.5, eaves - 2.5), 0.0));
    shape.parts.push_back(make_part({0.1 * length, 0.55 * width}, 0.0, 0.4 * length, 0.3 * width,
                                    PartForm::kFlat, std::max(2.5, eaves - 1.4), 0.0));
    add_machines(random->integer(5, 12), 0.4, 2.2, random, &shape);
    return shape;
  }
  if (random->chance(0.5)) add_machines(random->integer(1, 8), 0.3, 1.2, random, &shape);
  return shape;
}

/// Components of equal eaves and pitch on a plan of four and more wings.
BuiltShape many_wings(Random* random) {
  const double w = random->uniform(5.0, 7.0);
  const double eaves = wide_eaves(random);
  const double pitch = wide_pitch(random);
  std::vector<std::pair<Rectangle, Axis>> wings;
  const auto reach = [&] { return random->uniform(4.0, 7.5); };
  switch (random->integer(0, 3)) {
    case 0: {  // plus
      const double half = 0.5 * w;
      wings = {{{-half - reach(), half + reach(), -half, half}, Axis::kX},
               {{-half, half, -half - reach(), half + reach()}, Axis::kY}};
      break;
    }
    case 1: {  // H
      const double gap = 2.0 * w + random->uniform(3.0, 7.0);
      wings = {{{0.0, gap, -0.5 * w, 0.5 * w}, Axis::kX},
               {{0.0, w, -0.5 * w - reach(), 0.5 * w + reach()}, Axis::kY},
               {{gap - w, gap, -0.5 * w - reach(), 0.5 * w + reach()}, Axis::kY}};
      break;
    }
    case 2: {  // E
      const double gap = w + random->uniform(3.0, 5.0);
      wings = {{{0.0, 2.0 * gap + w, 0.0, w}, Axis::kX}};
      for (int i = 0; i < 3; ++i) {
        wings.push_back({{i * gap, i * gap + w, 0.0, w + reach()}, Axis::kY});
      }
      break;
    }
    default: {  // S: wings to either side at either end, and one in the middle
      const double length = 3.0 * w + random->uniform(4.0, 8.0);
      const double middle = 0.5 * (length - w);
      wings = {{{0.0, length, 0.0, w}, Axis::kX},
               {{0.0, w, 0.0, w + reach()}, Axis::kY},
               {{length - w, length, -reach(), w}, Axis::kY},
               {{middle, middle + w, -reach(), w + reach()}, Axis::kY}};
      break;
    }
  }
  BuiltShape shape;
  const bool flat = random->chance(0.1);
  const bool hipped = random->chance(0.35);
  for (const auto& [rectangle, ridge] : wings) {
    BuiltPart part = gable_over(rectangle, ridge, eaves, pitch);
    if (flat) part.form = PartForm::kFlat;
    if (hipped) part.start_run = part.end_run = part.half_width;
    shape.parts.push_back(part);
  }
  return shape;
}

BuiltShape courtyard(Random* random) {
  const double w = random->uniform(4.5, 6.5);
  const double size_x = 2.0 * w + random->uniform(4.5, 11.0);
  const double size_y = 2.0 * w + random->uniform(4.5, 9.0);
  const double eaves = wide_eaves(random);
  const double pitch = wide_pitch(random);
  BuiltShape shape;
  shape.parts = {gable_over({0.0, size_x, 0.0, w}, Axis::kX, eaves, pitch),
                 gable_over({0.0, size_x, size_y - w, size_y}, Axis::kX, eaves, pitch),
                 gable_over({0.0, w, 0.0, size_y}, Axis::kY, eaves, pitch),
                 gable_over({size_x - w, size_x, 0.0, size_y}, Axis::kY, eaves, pitch)};
  if (random->chance(0.6)) {
    for (BuiltPart& part : shape.parts) part.start_run = part.end_run = part.half_width;
  }
  if (random->chance(0.3)) {
    shape.parts[1].eaves = std::max(2.3, eaves - random->uniform(0.5, 2.0));
  }
  return shape;
}

BuiltShape terrace(Random* random) {
  BuiltShape shape;
  const int units = random->integer(4, 7);
  const double unit = random->uniform(4.2, 6.5);
  const double width = random->uniform(6.5, 9.5);
  const double pitch = wide_pitch(random);
  const bool stepped_up = random->chance(0.5);
  double eaves = random->uniform(4.0, 6.5);
  double off = 0.0;
  for (int i = 0; i < units && i * unit < 29.0; ++i) {
    shape.parts.push_back(
        make_gable({i * unit, off}, 0.0, unit, width, std::max(2.5, eaves), pitch));
    if (random->chance(0.35)) {  // a lower part at the back
      const double depth = random->uniform(2.5, 4.5);
      BuiltPart back = make_part({i * unit, off - 0.5 * (width + depth)}, 0.0, 0.6 * unit, depth,
                                 random->chance(0.5) ? PartForm::kFlat : PartForm::kMono,
                                 random->uniform(2.3, 3.0), 0.8);
      shape.parts.push_back(back);
    }
    if (stepped_up) {
      eaves += (i % 2 == 0 ? 1.0 : (random->chance(0.5) ? -1.0 : 1.0)) * random->uniform(0.9, 1.6);
    } else {
      off += (random->chance(0.5) ? 1.0 : -1.0) * random->uniform(1.2, 2.5);
    }
  }
  return shape;
}

BuiltShape crescent(Random* random) {
  BuiltShape shape;
  const int units = random->integer(4, 7);
  const double unit = random->uniform(4.0, 5.5);
  const double width = random->uniform(6.0, 8.5);
  const double pitch = wide_pitch(random);
  const double eaves = random->uniform(4.0, 6.5);
  const double bend = random->uniform(12.0, 24.0) * kDegree;
  Eigen::Vector2d at(0.0, 0.0);
  double azimuth = 0.0;
  for (int i = 0; i < units && i * unit < 27.0; ++i) {
    shape.parts.push_back(
        make_gable(at, azimuth, unit + width * std::tan(0.5 * bend), width, eaves, pitch));
    at += 0.5 * unit * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
    azimuth += bend;
    at += 0.5 * unit * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
  }
  return shape;
}

BuiltShape small_things(Random* random) {
  BuiltShape shape;
  const int count = random->integer(3, 6);
  for (int i = 0; i < count; ++i) {
    const double length = random->uniform(2.5, 7.0);
    const double width = random->uniform(2.0, 3.2);
    const double kind = random->uniform(0.0, 1.0);
    const PartForm form = kind < 0.4   ? PartForm::kFlat
                          : kind < 0.6 ? PartForm::kGable
                          : kind < 0.8 ? PartForm::kBarrel
                                       : PartForm::kMono;
    const Eigen::Vector2d at =
        i == 0 ? Eigen::Vector2d(0.0, 0.0)
               : Eigen::Vector2d(
                     shape.parts.back().center +
                     random->uniform(1.8, 3.0) *
                         Eigen::Vector2d(random->uniform(-1.0, 1.0), random->uniform(-1.0, 1.0)));
    shape.parts.push_back(make_part(at, random->uniform(0.0, M_PI), length, width, form,
                                    random->uniform(1.9, 3.0), random->uniform(0.3, 1.0)));
  }
  return shape;
}

BuiltShape composite(Random* random) { return shape_of(random_composite(random)); }

bool is_too_large(const BuiltShape& shape) {
  Eigen::Vector2d low = shape.parts[0].center, high = low;
  for (const BuiltPart& part : shape.parts) {
    for (const Eigen::Vector2d& corner : part.ring()) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  return (high - low).norm() > kLargest;
}

}  // namespace

House random_composite(Random* random) {
  const int count = random->integer(4, 6);
  House house;
  house.foundation = Foundation::kC;
  const double eaves = random_eaves(random) + random->uniform(0.3, 1.5);
  const double width = random->uniform(5.0, 9.0);
  std::vector<Rectangle> rectangles = {{0.0, width * random->uniform(1.0, 1.5), 0.0, width}};
  add_block(rectangles[0], eaves, false, random, &house);
  while (house.num_components() < count) {
    const Rectangle& to =
        rectangles[static_cast<size_t>(random->integer(0, house.num_components() - 1))];
    const Rectangle r = attached(to, random);
    House larger = house;
    const double height = random->chance(0.4) ? eaves : eaves + random->uniform(-2.5, 2.5);
    add_block(r, std::max(2.4, height), random->chance(0.15), random, &larger);
    if (!is_distinct(larger)) continue;
    rectangles.push_back(r);
    house = larger;
  }
  if (random->chance(0.3)) add_dormers(random, &house);
  if (random->chance(0.5)) add_chimneys(random, &house);
  return house;
}

BuiltShape random_complex(ComplexKind kind, Random* random) {
  using Make = BuiltShape (*)(Random*);
  constexpr std::array<Make, kNumComplexKinds> kMakers = {
      composite,  turned_wings, round_building, mansard,  hall,
      many_wings, courtyard,    terrace,        crescent, small_things};
  const Make make = kMakers[static_cast<size_t>(kind)];
  BuiltShape shape = make(random);
  while (is_too_large(shape)) shape = make(random);
  return placed(std::move(shape), random);
}

BuiltShape random_complex(Random* random) {
  constexpr std::array<double, kNumComplexKinds> kShares = {0.26, 0.16, 0.08, 0.06, 0.11,
                                                            0.12, 0.05, 0.08, 0.05, 0.03};
  double left = random->uniform(0.0, 1.0);
  int kind = 0;
  while (kind + 1 < kNumComplexKinds && left >= kShares[static_cast<size_t>(kind)]) {
    left -= kShares[static_cast<size_t>(kind++)];
  }
  return random_complex(static_cast<ComplexKind>(kind), random);
}

}  // namespace gable
