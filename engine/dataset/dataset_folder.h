#pragma once

#include <gable/engine/dataset/training_sample.h>

#include <cstddef>
#include <string>
#include <vector>

namespace gable {

/// Writes samples as the shards of a training set, `shard` a file, and `dataset.json` at last: a
/// folder without it is not complete.
class DatasetFolder {
 public:
  /// The folder exists; an earlier set in it is not complete any more. `source` says where the
  /// samples come from and goes into dataset.json.
  DatasetFolder(const std::string& folder, const std::string& source);

  /// Writes the next shard. Throws Error (kCannotWrite).
  void append(const std::vector<TrainingSample>& samples);
  /// Throws Error (kCannotWrite).
  void close();

  size_t count() const { return count_; }

 private:
  std::string folder_;
  std::string source_;
  size_t count_ = 0;
  int shards_ = 0;
};

}  // namespace gable
