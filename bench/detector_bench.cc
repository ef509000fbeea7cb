#include <benchmark/benchmark.h>
#include <gable/engine/detectors/detect_house.h>
#include <gable/engine/error.h>
#include <gable/engine/io/model_folder.h>

#include <opencv2/core/utility.hpp>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/scene_image.h"

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

// The shipped networks, or nothing and a message in `state`.
std::optional<DetectorNets> shipped_nets(benchmark::State& state) {
  cv::setNumThreads(1);
  try {
    return DetectorNets(find_detector_models());
  } catch (const Error& error) {
    state.SkipWithError(error.what());
    return std::nullopt;
  }
}

std::vector<HeightImage> scene_images() {
  std::vector<HeightImage> images;
  for (int i = 0; i < 10; ++i) {
    SceneOptions options;
    options.seed = 177 + static_cast<uint64_t>(i);
    images.push_back(scene_image(make_scene(kTypes[i % 5], options)));
  }
  return images;
}

// All that the detectors do for one house, single thread: both crops, azimuth, foundation and maps,
// candidates of rectangles and polygons, the roofs of all hypotheses, houses. Iterations take turns
// over ten scenes, two of every foundation type.
void BM_DetectHouse(benchmark::State& state) {
  std::optional<DetectorNets> nets = shipped_nets(state);
  if (!nets) return;
  const std::vector<HeightImage> images = scene_images();
  size_t next = 0;
  for (auto _ : state) {
    const HeightImage& image = images[next++ % images.size()];
    const AzimuthAnswer azimuth = detect_azimuth(image, &*nets);
    const HouseCrop crop = make_house_crop(image, azimuth.angle());
    benchmark::DoNotOptimize(detect_house(crop, image, &*nets));
  }
}
BENCHMARK(BM_DetectHouse)->Unit(benchmark::kMillisecond);

// What of it is not networks: the candidates and houses of answers known before.
void BM_FoundationHypotheses(benchmark::State& state) {
  std::optional<DetectorNets> nets = shipped_nets(state);
  if (!nets) return;
  std::vector<HouseCrop> crops;
  for (const HeightImage& image : scene_images()) {
    crops.push_back(make_house_crop(image, nets->azimuth(make_house_crop(image, 0.0)).angle()));
  }
  const std::vector<CropAnswer> answers = nets->look(crops);
  size_t next = 0;
  for (auto _ : state) {
    const size_t i = next++ % crops.size();
    benchmark::DoNotOptimize(foundation_hypotheses(crops[i], answers[i]));
  }
}
BENCHMARK(BM_FoundationHypotheses)->Unit(benchmark::kMillisecond);

// One batch of the house network, by crop.
void BM_HouseNet(benchmark::State& state) {
  std::optional<DetectorNets> nets = shipped_nets(state);
  if (!nets) return;
  const std::vector<HouseCrop> crops(static_cast<size_t>(state.range(0)),
                                     make_house_crop(scene_images()[0], 0.3));
  for (auto _ : state) benchmark::DoNotOptimize(nets->look(crops));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(BM_HouseNet)->Arg(1)->Arg(32)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gable
