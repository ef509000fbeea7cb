#include <gable/grammar/synthesis/houses/roof_clutter.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// A flat piece of the given size around a point (u, v) of a part's frame.
BuiltPart piece_of(const BuiltPart& part, double u, double v, double half_length, double half_width,
                   double lift) {
  const Eigen::Vector2d across(-part.along.y(), part.along.x());
  BuiltPart piece;
  piece.center = part.center + u * part.along + v * across;
  piece.along = part.along;
  piece.half_length = half_length;
  piece.half_width = half_width;
  piece.eaves = lift;
  return piece;
}

void add_parapet(const BuiltPart& roof, Random* random, std::vector<BuiltPart>* lifts) {
  const double lift = random->uniform(0.2, 0.8);
  const double half = random->uniform(0.12, 0.25);
  const double l = roof.half_length, w = roof.half_width;
  lifts->push_back(piece_of(roof, 0.0, w - half, l, half, lift));
  lifts->push_back(piece_of(roof, 0.0, half - w, l, half, lift));
  lifts->push_back(piece_of(roof, l - half, 0.0, half, w - 2.0 * half, lift));
  lifts->push_back(piece_of(roof, half - l, 0.0, half, w - 2.0 * half, lift));
}

void add_on_flat(const BuiltPart& roof, Random* random, std::vector<BuiltPart>* lifts) {
  if (random->chance(0.5)) add_parapet(roof, random, lifts);
  const int count = random->integer(0, 3);
  for (int i = 0; i < count; ++i) {
    const double half_length = random->uniform(0.3, 1.1), half_width = random->uniform(0.3, 0.8);
    lifts->push_back(piece_of(roof, random->uniform(-0.7, 0.7) * roof.half_length,
                              random->uniform(-0.7, 0.7) * roof.half_width, half_length, half_width,
                              random->uniform(0.2, 1.2)));
  }
}

void add_panels(const BuiltPart& roof, Random* random, std::vector<BuiltPart>* lifts) {
  const double side = random->chance(0.5) ? 1.0 : -1.0;
  const double low = random->uniform(0.05, 0.3), high = random->uniform(0.6, 0.92);
  const double clear = std::max(roof.start_run, roof.end_run);
  const double room = roof.half_length - clear - 0.3;
  if (room < 1.0) return;
  const double half_length = random->uniform(0.4, 1.0) * room;
  const double u = random->uniform(-1.0, 1.0) * (room - half_length);
  lifts->push_back(piece_of(roof, u, side * 0.5 * (low + high) * roof.half_width, half_length,
                            0.5 * (high - low) * roof.half_width, random->uniform(0.1, 0.2)));
}

void add_bumps(const BuiltPart& roof, Random* random, std::vector<BuiltPart>* lifts) {
  const int count = random->integer(1, 3);
  for (int i = 0; i < count; ++i) {
    const double half = random->uniform(0.12, 0.4);
    lifts->push_back(piece_of(roof, random->uniform(-0.9, 0.9) * (roof.half_length - half),
                              random->uniform(-0.9, 0.9) * (roof.half_width - half), half, half,
                              random->uniform(0.15, 0.6)));
  }
}

/// Continues a roof's planes over its walls.
void hang_over(double by, BuiltPart* roof) {
  const double slope = roof->form == PartForm::kFlat ? 0.0 : roof->rise / roof->half_width;
  roof->half_length += by;
  roof->half_width += by;
  roof->eaves -= by * slope;
  roof->rise += by * slope;
  if (roof->start_run > 0.0) roof->start_run += by;
  if (roof->end_run > 0.0) roof->end_run += by;
}

/// A bay or an oriel in front of one wall, its ground at height `ground`.
BuiltPart random_bay(const BuiltPart& roof, double ground, Random* random) {
  const double depth = random->uniform(0.3, 0.9);
  const double half = random->uniform(0.7, 1.6);
  const double lowest = std::min(2.4, roof.eaves - ground);
  const double top = ground + random->uniform(lowest, roof.eaves - ground);
  const bool at_end = random->chance(0.4);
  const double sign = random->chance(0.5) ? 1.0 : -1.0;
  const double wall = at_end ? roof.half_width : roof.half_length;
  const double along = random->uniform(-1.0, 1.0) * std::max(0.0, wall - half);
  const double out = sign * ((at_end ? roof.half_length : roof.half_width) + 0.5 * depth);
  return at_end ? piece_of(roof, out, along, 0.5 * depth, std::min(half, wall), top)
                : piece_of(roof, along, out, std::min(half, wall), 0.5 * depth, top);
}

}  // namespace

void add_roof_clutter(const House& house, Random* random, BuiltShape* shape) {
  const double overhang = random->chance(0.4) ? random->uniform(0.05, 0.3) : 0.0;
  const bool has_bay = random->chance(0.3);
  const size_t components = static_cast<size_t>(house.num_components());
  for (size_t i = 0; i < components; ++i) {
    const BuiltPart roof = shape->parts[i];
    if (roof.form == PartForm::kFlat) {
      add_on_flat(roof, random, &shape->lifts);
    } else {
      if (random->chance(0.3)) add_panels(roof, random, &shape->lifts);
      if (random->chance(0.4)) add_bumps(roof, random, &shape->lifts);
    }
    hang_over(overhang, &shape->parts[i]);
    if (has_bay && i == 0) shape->parts.push_back(random_bay(roof, house.origin.z(), random));
  }
}

}  // namespace gable
