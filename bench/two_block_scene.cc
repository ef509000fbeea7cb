#include "two_block_scene.h"

#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>

#include <cmath>

namespace gable {

TwoBlockScene make_two_block_scene() {
  TwoBlockScene scene;
  House& truth = scene.truth;
  truth = make_house(Foundation::kII);
  truth.azimuth[0] = 0.35;
  truth.footprints[0].values = {-2.0, -1.5, 14.0, 9.0};
  truth.footprints[1].values = {2.5, 4.5, 7.0, 9.0};
  truth.roofs[0] = make_rule(RuleKind::kRoofHip);
  truth.roofs[0].values = {5.5, 3.0, 0.3, 0.25};
  truth.roofs[1] = make_rule(RuleKind::kRoofGable);
  truth.roofs[1].values = {4.8, 2.6};
  truth.roofs[1].ridge = Axis::kY;

  scene.start = truth;
  House& start = scene.start;
  start.azimuth[0] += 3.0 * M_PI / 180.0;
  start.footprints[0].values = {-1.0, -2.3, 12.6, 9.9};
  start.footprints[1].values = {3.4, 3.6, 7.7, 8.1};
  start.roofs[0].values = {6.0, 2.5, 0.2, 0.35};
  start.roofs[1].values = {4.3, 3.1};

  HeightImage& image = scene.image;
  image.rows = 64;
  image.cols = 64;
  image.gsd = 0.5;
  image.first_center = {-15.75, 15.75};
  image.ground.assign(image.size(), 0.0f);
  image.weight.assign(image.size(), 1.0f);
  const HeightField field(truth);
  const Eigen::Vector2d tree(-9.5, 5.0);
  Random random(7);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      double height = field.at_local(p, image.gsd, 0.0);
      const double crown = 1.0 - (p - tree).squaredNorm() / 9.0;
      if (crown > 0.0) height = std::max(height, 4.0 + 4.0 * std::sqrt(crown));
      if (random.chance(0.7)) height += random.uniform(-0.3, 0.3);
      if (random.chance(0.03)) height = random.uniform(0.0, 12.0);
      image.height.push_back(static_cast<float>(height));
    }
  }
  return scene;
}

}  // namespace gable
