#pragma once

#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace gable {

// What a pixel costs is smooth except on kinks, where it switches from one smooth formula to
// another: which blocks are seen in which order, which facet holds the centroid of a block's
// covered part (or each point that its mean height is taken at), in which order the edges of the
// covered parts come, which sides of a dormer end at the wall. A PixelState names the formula, so a
// pixel whose state is the same at both ends and in the middle of a differencing interval is
// differenced within one smooth formula, and its differences must equal the analytic derivative.
// Pixels whose state changes are left out: they are few, and an exact derivative does not exist
// there. All conditions are signs of functions that are monotone over intervals as short as the
// tests use.
struct PixelState {
  std::vector<int> blocks;  // highest first
  std::vector<unsigned> forms;
  std::vector<int> x_order, y_order;  // edges of the covered parts, sorted
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
  if (b.mansard) {
    const double share = std::min(2.0 * (v - v0) / (v1 - v0), 2.0 * (v1 - v) / (v1 - v0));
    return 4 + (share > b[kBreakRun] ? 2 : 0) + (v - v0 < v1 - v ? 1 : 0);
  }
  const double shares[4] = {2.0 * (v - v0) / (v1 - v0), 2.0 * (v1 - v) / (v1 - v0),
                            b[kHipStart] > 0.0 ? (u - u0) / (b[kHipStart] * (u1 - u0)) : 1e300,
                            b[kHipEnd] > 0.0 ? (u1 - u) / (b[kHipEnd] * (u1 - u0)) : 1e300};
  return static_cast<int>(std::min_element(shares, shares + 4) - shares);
}

// The edges' numbers in order of their values; equal edges (of one support) keep theirs.
inline std::vector<int> order(const std::vector<double>& edges) {
  std::vector<int> numbers(edges.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](int a, int b) { return edges[a] < edges[b]; });
  return numbers;
}

}  // namespace kinks_internal

inline PixelState pixel_state(const HeightField& field, const House& house,
                              const Eigen::Vector2d& local, double support,
                              RoofSampling sampling = RoofSampling::kCentroid) {
  const Eigen::Vector2d p = field.house_from_local(local);
  const auto& blocks = field.blocks();
  const Layers<double> seen = layers_at<double, double>(blocks, p.x(), p.y(), support, sampling);
  PixelState state;
  // The support's own edges come first: they tell which sides of a part are cut off.
  std::vector<double> x_edges = {p.x() - 0.5 * support, p.x() + 0.5 * support};
  std::vector<double> y_edges = {p.y() - 0.5 * support, p.y() + 0.5 * support};
  for (int k = 0; k < seen.count; ++k) {
    const int id = seen.layers[k].block;
    const auto part = covered_part<double, double>(blocks[id], p.x(), p.y(), support);
    x_edges.insert(x_edges.end(), {part.x0, part.x1});
    y_edges.insert(y_edges.end(), {part.y0, part.y1});
    const std::vector<double> shares =
        sampling == RoofSampling::kMean
            ? std::vector<double>(kGaussPoints.begin(), kGaussPoints.end())
            : std::vector<double>{0.5};
    unsigned form = 0;
    for (const double u : shares) {
      for (const double v : shares) {
        form = 8 * form + static_cast<unsigned>(
                              kinks_internal::facet(blocks[id], part.x0 + u * (part.x1 - part.x0),
                                                    part.y0 + v * (part.y1 - part.y0)));
      }
    }
    const double cut[4] = {part.x0 - x_edges[0], x_edges[1] - part.x1, part.y0 - y_edges[0],
                           y_edges[1] - part.y1};
    for (double c : cut) form = 2 * form + (c > 0.0 ? 1 : 0);
    const BlockSource& source = field.sources()[id];
    if (source.role == BlockRole::kDormer) {
      const Block<double>& parent = blocks[house.dormers[source.index].component];
      for (int side = 0; side < 4; ++side) {
        form = 2 * form + (blocks[id][side] == parent[side] ? 1 : 0);
      }
    }
    state.blocks.push_back(id);
    state.forms.push_back(form);
  }
  state.x_order = kinks_internal::order(x_edges);
  state.y_order = kinks_internal::order(y_edges);
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
                             RoofSampling sampling = RoofSampling::kCentroid) {
  const PixelState state = pixel_state(center, house, local, support, sampling);
  return std::all_of(fields.begin(), fields.end(), [&](const HeightField& field) {
    return pixel_state(field, house, local, support, sampling) == state;
  });
}

inline bool is_smooth_around(const House& house, const Eigen::Vector2d& local, double support,
                             double step) {
  return is_smooth_around(HeightField(house), moved_fields(house, step), house, local, support);
}

}  // namespace gable
