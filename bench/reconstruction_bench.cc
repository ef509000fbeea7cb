#include <benchmark/benchmark.h>
#include <gable/engine/reconstruct/choice/house_choice.h>
#include <gable/engine/reconstruct/finding/vegetation.h>

#include <vector>

#include "accuracy/scene_image.h"

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

// One house from its crop, all hypotheses, single thread. Iterations take turns over ten scenes of
// 64 x 64 pixels at 0.5 m, two of every foundation type, with the paper's noise, every other one
// with a tree.
void BM_ReconstructHouse(benchmark::State& state) {
  std::vector<HeightImage> images;
  for (int i = 0; i < 10; ++i) {
    SceneOptions options;
    options.seed = 77 + static_cast<uint64_t>(i);
    options.trees = i % 2;
    images.push_back(scene_image(make_scene(kTypes[i % 5], options)));
    leave_out_vegetation({}, &images.back());
  }
  size_t next = 0;
  for (auto _ : state) {
    const HouseChoice choice = choose_house(images[next++ % images.size()], {});
    benchmark::DoNotOptimize(choice.best.cost.total);
  }
}
BENCHMARK(BM_ReconstructHouse)->Unit(benchmark::kMillisecond)->Iterations(40);

}  // namespace
}  // namespace gable
