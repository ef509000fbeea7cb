// A house refined against heights: from a start that is a metre off to a few centimetres.
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/synthesis/scene.h>

#include <cstdio>

int main() {
  using namespace gable;
  const Scene scene = make_scene(Foundation::kL, {.seed = 3});  // rasters around a random house
  const HeightImage image = height_image(scene.dsm, scene.dtm, scene.house.origin);

  House house = scene.house;
  house.azimuth[0] += 0.05;
  house.footprints[0][param::l_polygon::kWingXLength] += 1.5;
  for (Rule& roof : house.roofs) roof[param::roof::kEaves] -= 1.0;

  const RefinementSummary summary = refine_house(image, RefinementOptions{}, &house);
  std::printf("%s after %d steps, mean distance %.2f m\n", termination_name(summary.termination),
              summary.iterations, summary.mad);
}
