#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gable {

inline Rule rectangle_rule(double x0, double x1, double y0, double y1) {
  Rule rule = make_rule(RuleKind::kFootprintI);
  rule.values = {0.5 * (x0 + x1), 0.5 * (y0 + y1), x1 - x0, y1 - y0};
  return rule;
}

inline Rule flat_roof(double eaves) {
  Rule rule = make_rule(RuleKind::kRoofFlat);
  rule[param::roof::kEaves] = eaves;
  return rule;
}

inline Rule gable_roof(double eaves, double rise, Axis ridge) {
  Rule rule = make_rule(RuleKind::kRoofGable);
  rule.values = {eaves, rise};
  rule.ridge = ridge;
  return rule;
}

inline Rule hip_roof(double eaves, double rise, double start, double end, Axis ridge) {
  Rule rule = make_rule(RuleKind::kRoofHip);
  rule.values = {eaves, rise, start, end};
  rule.ridge = ridge;
  return rule;
}

inline Rule mansard_roof(double eaves, double rise, double break_height, double break_run,
                         Axis ridge) {
  Rule rule = make_rule(RuleKind::kRoofMansard);
  rule.values = {eaves, rise, break_height, break_run};
  rule.ridge = ridge;
  return rule;
}

// One rectangle around the origin.
inline House box_house(double length, double width, const Rule& roof, double azimuth = 0.0) {
  House house = make_house(Foundation::kI);
  house.azimuth[0] = azimuth;
  house.footprints = {rectangle_rule(-0.5 * length, 0.5 * length, -0.5 * width, 0.5 * width)};
  house.roofs = {roof};
  return house;
}

// Largest difference of two houses' heights at random points of a square of the local frame.
inline double surface_difference(const House& a, const House& b, double half, uint64_t seed) {
  const HeightField field_a(a), field_b(b);
  Random random(seed);
  double largest = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const Eigen::Vector2d p(random.uniform(-half, half), random.uniform(-half, half));
    largest =
        std::max(largest, std::abs(field_a.at_local(p, 0.0, 0.0) - field_b.at_local(p, 0.0, 0.0)));
  }
  return largest;
}

}  // namespace gable
