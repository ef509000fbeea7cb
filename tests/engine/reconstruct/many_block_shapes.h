#pragma once

#include <gable/grammar/wing_polygons.h>

#include <string>
#include <vector>

#include "grammar/sample_houses.h"

namespace gable {

// A house of two or more blocks with a name to say which.
struct ManyBlockShape {
  std::string name;
  House house;
};

inline House t_shape() {
  return blocks_house({{-10.0, 10.0, 0.0, 8.0, gable_roof(5.0, 3.0, Axis::kX)},
                       {-3.0, 3.5, -9.0, 4.0, gable_roof(4.2, 2.4, Axis::kY)}},
                      0.4);
}

inline House cross_shape() {
  return blocks_house({{-12.0, 12.0, -3.5, 3.5, gable_roof(5.0, 2.6, Axis::kX)},
                       {-3.5, 3.5, -11.0, 11.0, gable_roof(5.0, 2.6, Axis::kY)}},
                      0.25);
}

inline House z_shape() {
  return blocks_house({{-4.0, 4.0, -10.0, 10.0, gable_roof(5.5, 3.0, Axis::kY)},
                       {-13.0, -4.0, 3.0, 10.0, gable_roof(4.0, 2.5, Axis::kX)},
                       {4.0, 12.0, -10.0, -3.0, flat_roof(4.4)}},
                      0.9);
}

// Five units whose eaves step.
inline House terrace_shape() {
  const double eaves[] = {4.5, 5.7, 4.8, 6.2, 5.0};
  std::vector<RoofedRectangle> units;
  for (int i = 0; i < 5; ++i) {
    const double x0 = -13.0 + 5.2 * i;
    units.push_back({x0, x0 + 5.2, -4.0, 4.0, gable_roof(eaves[i], 3.0, Axis::kX)});
  }
  return blocks_house(units, 0.6);
}

// A comb of a back and three wings of different heights.
inline House e_shape() {
  return blocks_house({{-13.0, 13.0, 0.0, 6.0, gable_roof(6.0, 2.5, Axis::kX)},
                       {-13.0, -8.0, -8.0, 0.0, gable_roof(4.0, 2.0, Axis::kY)},
                       {-2.5, 2.5, -9.0, 0.0, flat_roof(5.0)},
                       {8.0, 13.0, -8.0, 0.0, gable_roof(4.6, 2.0, Axis::kY)}},
                      0.2);
}

inline std::vector<ManyBlockShape> many_block_shapes() {
  return {{"T", t_shape()},
          {"cross", cross_shape()},
          {"Z", z_shape()},
          {"terrace", terrace_shape()},
          {"E", e_shape()}};
}

// Mean difference of two houses' heights over what either covers, metres.
inline double mean_difference(const House& a, const House& b) {
  const HeightField field_a(a), field_b(b);
  double sum = 0.0;
  int count = 0;
  for (double x = -18.0; x < 18.0; x += 0.3) {
    for (double y = -18.0; y < 18.0; y += 0.3) {
      const double p = field_a.at_local({x, y}, 0.0, 0.0), q = field_b.at_local({x, y}, 0.0, 0.0);
      if (p == 0.0 && q == 0.0) continue;
      sum += std::abs(p - q);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace gable
