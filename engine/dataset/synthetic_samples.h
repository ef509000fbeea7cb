#pragma once

#include <gable/engine/dataset/training_sample.h>
#include <gable/grammar/synthesis/training_scene.h>

#include <cstdint>
#include <string>

namespace gable {

struct DatasetOptions {
  int count = 150000;  ///< crops, [1, 100000000]
  uint64_t seed = 1;
  int shard = 4096;  ///< crops a shard, [1, 65536]
  /// Houses of which dormers are added, beyond those of the prior, as the paper's augmentation
  /// does (NPR section 5.3), [0, 1].
  double dormer_share = 0.35;
  TrainingSceneOptions scene;

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// Sample `index` of the synthetic set: foundations I, II, III, L, U and C in turn. Depends on the
/// options' seed and the index alone. Scenes in which no building is found are drawn again.
TrainingSample synthetic_sample(size_t index, const DatasetOptions& options);

}  // namespace gable
