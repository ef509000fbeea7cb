#include <gable/engine/reconstruct/choice/narrow_blocks.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <vector>

namespace gable {
namespace {

// Share of what a component shows that lies in squares of 3 x 3 pixels.
constexpr double kWideShare = 0.5;

// Share of a component that lies within another.
constexpr double kNestedShare = 0.7;

/// The component that each pixel sees from above, by number; -1: none, or a garage.
std::vector<int> components_seen(const HeightImage& image, const HeightField& field) {
  std::vector<Block<double>> ground;
  std::vector<int> component;
  int next = 0;
  for (size_t b = 0; b < field.blocks().size(); ++b) {
    const BlockRole role = field.sources()[b].role;
    if (stands_on_roof(role)) continue;
    ground.push_back(field.blocks()[b]);
    component.push_back(role == BlockRole::kComponent ? next++ : -1);
  }
  std::vector<int> seen(image.size(), -1);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      const auto layers = layers_at<double, double>(ground, p.x(), p.y(), 0.0);
      if (layers.count > 0) seen[image.index(row, col)] = component[layers.layers[0].block];
    }
  }
  return seen;
}

double common_length(const Block<double>& a, const Block<double>& b, int low) {
  return std::max(0.0, std::min(a[low + 1], b[low + 1]) - std::max(a[low], b[low]));
}

double plan_area(const Block<double>& block) {
  using namespace block_value;
  return (block[kX1] - block[kX0]) * (block[kY1] - block[kY0]);
}

/// Of each component whether it lies within another for the most part, or another within it.
std::vector<char> nested_components(const HeightField& field) {
  using namespace block_value;
  std::vector<Block<double>> components;
  for (size_t b = 0; b < field.blocks().size(); ++b) {
    if (field.sources()[b].role == BlockRole::kComponent) components.push_back(field.blocks()[b]);
  }
  std::vector<char> nested(components.size(), 0);
  for (size_t a = 0; a < components.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      const double common = common_length(components[a], components[b], kX0) *
                            common_length(components[a], components[b], kY0);
      const double smaller = std::min(plan_area(components[a]), plan_area(components[b]));
      if (common >= kNestedShare * smaller) nested[a] = nested[b] = 1;
    }
  }
  return nested;
}

}  // namespace

int count_narrow_blocks(const HeightImage& image, const House& house) {
  if (house.num_components() < 2) return 0;
  const HeightField field(house);
  const std::vector<char> nested = nested_components(field);
  if (std::find(nested.begin(), nested.end(), 1) == nested.end()) return 0;
  const std::vector<int> seen = components_seen(image, field);
  std::vector<unsigned char> wide(image.size(), 0);
  const auto same_around = [&](int row, int col) {
    const int own = seen[image.index(row, col)];
    for (int r = row - 1; r <= row + 1; ++r) {
      for (int c = col - 1; c <= col + 1; ++c) {
        if (seen[image.index(r, c)] != own) return false;
      }
    }
    return own >= 0;
  };
  for (int row = 1; row + 1 < image.rows; ++row) {
    for (int col = 1; col + 1 < image.cols; ++col) {
      if (!same_around(row, col)) continue;
      for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = col - 1; c <= col + 1; ++c) wide[image.index(r, c)] = 1;
      }
    }
  }
  std::vector<int> pixels(house.num_components(), 0), in_squares(house.num_components(), 0);
  for (size_t i = 0; i < image.size(); ++i) {
    if (seen[i] < 0) continue;
    ++pixels[seen[i]];
    in_squares[seen[i]] += wide[i];
  }
  int narrow = 0;
  for (int k = 0; k < house.num_components(); ++k) {
    narrow += nested[k] && in_squares[k] <= kWideShare * pixels[k];
  }
  return narrow;
}

}  // namespace gable
