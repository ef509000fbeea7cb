#pragma once

#include <gable/grammar/synthesis/scene.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// The whole crop of a scene as a height image in the true house's local frame; inside: heights
/// above 2 m over the terrain.
inline HeightImage scene_image(const Scene& scene) {
  const Grid& grid = scene.dsm.grid;
  HeightImage image;
  image.origin = scene.house.origin;
  image.gsd = grid.gsd;
  image.rows = grid.rows;
  image.cols = grid.cols;
  image.first_center = grid.center_of(0, 0) - image.origin.head<2>();
  for (size_t i = 0; i < grid.size(); ++i) {
    const double z = image.origin.z();
    image.height.push_back(static_cast<float>(scene.dsm.values[i] - z));
    image.ground.push_back(static_cast<float>(scene.dtm.values[i] - z));
    image.weight.push_back(1.0f);
    image.inside.push_back(scene.dsm.values[i] - scene.dtm.values[i] > 2.0f);
  }
  return image;
}

}  // namespace gable
