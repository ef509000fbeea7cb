#pragma once

#include <gable/engine/dataset/training_sample.h>

#include <string>
#include <vector>

namespace gable {

/// One array of a shard as a file.
struct ShardFile {
  std::string name;   ///< for instance "crops_0003.npy"
  std::string bytes;  ///< NPY
};

/// The arrays of docs/detectors.md for some samples. Points beyond the arrays' room (8 dormers, 4
/// chimneys) are left out, and `details_known` is then 0.
std::vector<ShardFile> shard_files(int number, const std::vector<TrainingSample>& samples);

}  // namespace gable
