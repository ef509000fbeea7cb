#include <gable/engine/dataset/synthetic_samples.h>
#include <glog/logging.h>

namespace gable {
namespace {

constexpr Foundation kInTurn[] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                                  Foundation::kL, Foundation::kU,  Foundation::kC};

}  // namespace

std::string DatasetOptions::check() const {
  if (!(count >= 1 && count <= 100000000)) return "count must be in [1, 100000000]";
  if (!(shard >= 1 && shard <= 65536)) return "shard must be in [1, 65536]";
  if (!(dormer_share >= 0.0 && dormer_share <= 1.0)) return "dormer_share must be in [0, 1]";
  return scene.check();
}

TrainingSample synthetic_sample(size_t index, const DatasetOptions& options) {
  CHECK(options.check().empty()) << options.check();
  // The seed is spread first: seeds 1 and 2 share no samples.
  Random random(Random(options.seed).next() + index);
  while (true) {
    Random draw = random.fork();
    TrainingSceneOptions scene = options.scene;
    scene.prior.dormer_share =
        draw.chance(options.dormer_share) ? 1.0 : options.scene.prior.dormer_share;
    const std::optional<TrainingSample> sample = make_training_sample(
        make_training_scene(kInTurn[index % std::size(kInTurn)], draw.next(), scene), &draw);
    if (sample) return *sample;
  }
}

}  // namespace gable
