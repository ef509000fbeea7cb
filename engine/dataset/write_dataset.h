#pragma once

#include <gable/engine/dataset/synthetic_samples.h>

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

namespace gable {

/// Writes the synthetic training set into a folder, shard by shard, and at last `dataset.json`,
/// which names the seed and the counts: a folder without it is not complete. `progress` is told how
/// many crops were made, on the calling thread. Files do not depend on the number of threads.
/// Returns false after a stop request. Throws Error (kCannotWrite).
bool write_dataset(const std::string& folder, const DatasetOptions& options, int threads,
                   const std::stop_token& stop, const std::function<void(size_t)>& progress);

}  // namespace gable
