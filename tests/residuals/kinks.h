#pragma once

#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {

// The height field is smooth except on kinks, where it switches from one smooth formula to another:
// which block is seen, which facet of it holds the support's centroid, which sides of the support
// are cut off, which sides of a dormer end at the wall. A PixelState names the formula, so a pixel
// whose state is the same at both ends and in the middle of a differencing interval is differenced
// within one smooth formula, and its differences must equal the analytic derivative. Pixels whose
// state changes are left out: they are few, and an exact derivative does not exist there.
// All conditions are signs of functions that are monotone over intervals as short as the tests use.
struct PixelState {
  int main = -1;           // component or garage seen
  int on_roof = -1;        // dormer or chimney seen
  unsigned main_form = 0;  // facet and cut sides
  unsigned on_roof_form = 0;
  bool operator==(const PixelState&) const = default;
};

namespace kinks_internal {

inline int facet(const Block<double>& b, double x, double y) {
  using namespace block_value;
  if (b.flat) return 0;
  const bool along_x = b.ridge == Axis::kX;
  const double u0 = along_x ? b[kX0] : b[kY0], u1 = along_x ? b[kX1] : b[kY1];
  const double v0 = along_x ? b[kY0] : b[kX0], v1 = along_x ? b[kY1] : b[kX1];
  const double u = along_x ? x : y, v = along_x ? y : x;
  const double shares[4] = {2.0 * (v - v0) / (v1 - v0), 2.0 * (v1 - v) / (v1 - v0),
                            b[kHipStart] > 0.0 ? (u - u0) / (b[kHipStart] * (u1 - u0)) : 1e300,
                            b[kHipEnd] > 0.0 ? (u1 - u) / (b[kHipEnd] * (u1 - u0)) : 1e300};
  return static_cast<int>(std::min_element(shares, shares + 4) - shares);
}

inline unsigned form(const Block<double>& b, double x, double y, double support) {
  using namespace block_value;
  const double half = 0.5 * support;
  const bool cut[4] = {x - half<b[kX0], x + half> b[kX1], y - half<b[kY0], y + half> b[kY1]};
  const double cx = 0.5 * (std::max(x - half, b[kX0]) + std::min(x + half, b[kX1]));
  const double cy = 0.5 * (std::max(y - half, b[kY0]) + std::min(y + half, b[kY1]));
  unsigned value = static_cast<unsigned>(facet(b, cx, cy));
  for (bool c : cut) value = 2 * value + (c ? 1 : 0);
  return value;
}

}  // namespace kinks_internal

inline PixelState pixel_state(const HeightField& field, const House& house,
                              const Eigen::Vector2d& local, double support, double ground) {
  const Eigen::Vector2d p = field.house_from_local(local);
  PixelState state;
  double main = ground, lift = 0.0;
  for (size_t i = 0; i < field.blocks().size(); ++i) {
    const Block<double>& block = field.blocks()[i];
    const auto sample = sample_block<double, double>(block, p.x(), p.y(), support);
    if (!(sample.coverage > 0.0)) continue;
    const BlockSource& source = field.sources()[i];
    const int id = static_cast<int>(i);
    if (stands_on_roof(source.role)) {
      const double gain = sample.coverage * (sample.height - main);
      if (gain > lift) {
        lift = gain;
        state.on_roof = id;
        state.on_roof_form = kinks_internal::form(block, p.x(), p.y(), support);
        if (source.role == BlockRole::kDormer) {
          const Block<double>& parent = field.blocks()[house.dormers[source.index].component];
          for (int side = 0; side < 4; ++side) {
            state.on_roof_form = 2 * state.on_roof_form + (block[side] == parent[side] ? 1 : 0);
          }
        }
      }
    } else {
      const double height = sample.coverage * (sample.height - ground) + ground;
      if (state.main < 0 || height > main) {
        main = height;
        state.main = id;
        state.main_form = kinks_internal::form(block, p.x(), p.y(), support);
      }
    }
  }
  return state;
}

// The house with parameter number `parameter` (in derivation order) moved.
inline House moved(const House& house, int parameter, double delta) {
  House out = house;
  for (Rule* rule : out.derivation()) {
    if (parameter < rule->size()) {
      (*rule)[parameter] += delta;
      return out;
    }
    parameter -= rule->size();
  }
  return out;
}

inline std::vector<double> all_values(const House& house) {
  std::vector<double> values;
  for (const Rule* rule : house.derivation()) {
    values.insert(values.end(), rule->parameters().begin(), rule->parameters().end());
  }
  return values;
}

// The fields at both ends of every parameter's differencing interval.
inline std::vector<HeightField> moved_fields(const House& house, double step) {
  const std::vector<double> values = all_values(house);
  std::vector<HeightField> fields;
  for (size_t k = 0; k < values.size(); ++k) {
    const double delta = step * std::max(1.0, std::abs(values[k]));
    fields.emplace_back(moved(house, static_cast<int>(k), delta));
    fields.emplace_back(moved(house, static_cast<int>(k), -delta));
  }
  return fields;
}

inline bool is_smooth_around(const HeightField& center, const std::vector<HeightField>& fields,
                             const House& house, const Eigen::Vector2d& local, double support,
                             double ground) {
  const PixelState state = pixel_state(center, house, local, support, ground);
  return std::all_of(fields.begin(), fields.end(), [&](const HeightField& field) {
    return pixel_state(field, house, local, support, ground) == state;
  });
}

inline bool is_smooth_around(const House& house, const Eigen::Vector2d& local, double support,
                             double ground, double step) {
  return is_smooth_around(HeightField(house), moved_fields(house, step), house, local, support,
                          ground);
}

}  // namespace gable
