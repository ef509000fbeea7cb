#include <gable/grammar/synthesis/roof_clutter.h>

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

}  // namespace

std::vector<BuiltPart> random_roof_clutter(const House& house, Random* random) {
  std::vector<BuiltPart> lifts;
  const BuiltShape shape = shape_of(house);
  for (int i = 0; i < house.num_components(); ++i) {
    const BuiltPart& roof = shape.parts[static_cast<size_t>(i)];
    if (roof.form == PartForm::kFlat) {
      add_on_flat(roof, random, &lifts);
      continue;
    }
    if (random->chance(0.3)) add_panels(roof, random, &lifts);
    if (random->chance(0.4)) add_bumps(roof, random, &lifts);
  }
  return lifts;
}

}  // namespace gable
