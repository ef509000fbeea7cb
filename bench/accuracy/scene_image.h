#pragma once

#include <gable/grammar/synthesis/scene.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// The whole crop of a scene as a height image in the true house's local frame; inside: heights
/// above 2 m over the terrain.
inline HeightImage scene_image(const Scene& scene) {
  return height_image(scene.dsm, scene.dtm, scene.house.origin);
}

}  // namespace gable
