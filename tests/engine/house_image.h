#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/scene.h>
#include <gable/residuals/height_image.h>

#include <vector>

#include "grammar/sample_houses.h"

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

// The same with heights that are means over a square of width `spread`, which lies as the house
// does, by point samples; noise on top.
inline HeightImage image_of_means(const House& house, double spread,
                                  const ViewOptions& options = {}) {
  ViewOptions clean = options;
  clean.noise = clean.outliers = 0.0;
  HeightImage image = image_of(house, clean);
  image.spread = spread;
  const HeightField field(house);
  Random random(options.seed);
  constexpr int kPoints = 30;
  for (size_t i = 0; i < image.size(); ++i) {
    const Eigen::Vector2d p = field.house_from_local(
        image.center_of(static_cast<int>(i) / image.cols, static_cast<int>(i) % image.cols));
    double sum = 0.0;
    for (int a = 0; a < kPoints; ++a) {
      for (int b = 0; b < kPoints; ++b) {
        const Eigen::Vector2d part((a + 0.5) / kPoints - 0.5, (b + 0.5) / kPoints - 0.5);
        sum += field.at_house(p + spread * part, 0.0, image.ground[i]);
      }
    }
    image.height[i] = static_cast<float>(sum / (kPoints * kPoints) + random.normal(options.noise));
    image.inside[i] = image.height[i] > 2.0f;
  }
  return image;
}

// The whole crop of a scene in the true house's local frame; inside: more than 2 m over the
// terrain.
inline HeightImage image_of(const Scene& scene) {
  return height_image(scene.dsm, scene.dtm, scene.house.origin);
}

}  // namespace gable
