#include <gable/grammar/random.h>
#include <gable/training/scans/block_building_surface.h>
#include <gable/training/scans/building_surface.h>
#include <gable/training/scans/random_house_surface.h>

namespace gable {

LabelledSurface random_building(uint64_t seed) {
  Random random(seed);
  return random.chance(2.0 / 3.0) ? random_house_surface(&random)
                                  : random_block_building_surface(&random);
}

}  // namespace gable
