#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/scene.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

// How a house is seen: square images around its frame's origin over level ground at 0.
struct ViewOptions {
  double gsd = 0.5;       // metres
  int size = 64;          // pixels a side
  double noise = 0.0;     // standard deviation, metres
  double outliers = 0.0;  // share of pixels at random heights in [0, 12] metres
  uint64_t seed = 1;
};

// Point samples of a house's heights; inside: more than 2 m over the ground.
inline HeightImage image_of(const House& house, const ViewOptions& options = {}) {
  HeightImage image;
  image.origin = house.origin;
  image.gsd = options.gsd;
  image.rows = image.cols = options.size;
  const double half = 0.5 * (options.size - 1) * options.gsd;
  image.first_center = {-half, half};
  image.ground.assign(image.size(), 0.0f);
  image.weight.assign(image.size(), 1.0f);
  const HeightField field(house);
  Random random(options.seed);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const double height = field.at_local(image.center_of(row, col), 0.0, 0.0);
      double seen = height + random.normal(options.noise);
      if (random.chance(options.outliers)) seen = random.uniform(0.0, 12.0);
      image.height.push_back(static_cast<float>(seen));
      image.inside.push_back(seen > 2.0);
    }
  }
  return image;
}

// The whole crop of a scene in the true house's local frame; inside: more than 2 m over the
// terrain.
inline HeightImage image_of(const Scene& scene) {
  const Grid& grid = scene.dsm.grid;
  HeightImage image;
  image.origin = scene.house.origin;
  image.gsd = grid.gsd;
  image.rows = grid.rows;
  image.cols = grid.cols;
  image.first_center = grid.center_of(0, 0) - image.origin.head<2>();
  image.weight.assign(grid.size(), 1.0f);
  for (size_t i = 0; i < grid.size(); ++i) {
    image.height.push_back(static_cast<float>(scene.dsm.values[i] - image.origin.z()));
    image.ground.push_back(static_cast<float>(scene.dtm.values[i] - image.origin.z()));
    image.inside.push_back(scene.dsm.values[i] - scene.dtm.values[i] > 2.0f);
  }
  return image;
}

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
