#include <gable/grammar/random.h>
#include <gable/training/scans/block_building_surface.h>
#include <gable/training/scans/building_surface.h>
#include <gable/training/scans/random_house_surface.h>

#include <algorithm>
#include <array>

namespace gable {

namespace {

/// Whether there are fewer planes at every coarser scale: not so for a box without any roof.
bool scales_differ(const LabelledSurface& surface) {
  std::array<int, kNumKnownScales> count = {};
  for (const auto& planes : surface.planes) {
    for (int k = 0; k < kNumKnownScales; ++k) count[k] = std::max(count[k], planes[k] + 1);
  }
  return count[0] > count[1] && count[1] > count[2];
}

}  // namespace

LabelledSurface random_building(uint64_t seed) {
  Random random(seed);
  for (;;) {
    LabelledSurface surface = random.chance(2.0 / 3.0) ? random_house_surface(&random)
                                                       : random_block_building_surface(&random);
    if (scales_differ(surface)) return surface;
  }
}

}  // namespace gable
