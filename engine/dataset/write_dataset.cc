#include <gable/engine/dataset/dataset_folder.h>
#include <gable/engine/dataset/write_dataset.h>
#include <gable/engine/parallel_ranges.h>
#include <glog/logging.h>

#include <algorithm>
#include <vector>

namespace gable {

bool write_dataset(const std::string& folder, const DatasetOptions& options, int threads,
                   const std::stop_token& stop, const std::function<void(size_t)>& progress) {
  CHECK(options.check().empty()) << options.check();
  DatasetFolder dataset(folder, "grammar, seed " + std::to_string(options.seed));
  const size_t count = static_cast<size_t>(options.count);
  const size_t shard = static_cast<size_t>(options.shard);
  constexpr size_t kAtOnce = 256;  // crops between two reports of progress
  for (size_t begin = 0; begin < count; begin += shard) {
    const size_t end = std::min(count, begin + shard);
    std::vector<TrainingSample> samples(end - begin);
    for (size_t first = begin; first < end; first += kAtOnce) {
      if (stop.stop_requested()) return false;
      const size_t size = std::min(kAtOnce, end - first);
      for_ranges(
          size, threads,
          [&](size_t low, size_t high) {
            for (size_t i = low; i < high; ++i) {
              samples[first - begin + i] = synthetic_sample(first + i, options);
            }
          },
          8);
      progress(size);
    }
    dataset.append(samples);
  }
  dataset.close();
  return true;
}

}  // namespace gable
