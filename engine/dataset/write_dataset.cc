#include <gable/engine/dataset/shard.h>
#include <gable/engine/dataset/write_dataset.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/parallel_ranges.h>
#include <glog/logging.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace gable {

bool write_dataset(const std::string& folder, const DatasetOptions& options, int threads,
                   const std::stop_token& stop, const std::function<void(size_t)>& progress) {
  CHECK(options.check().empty()) << options.check();
  const std::filesystem::path path(folder);
  const size_t count = static_cast<size_t>(options.count);
  const size_t shard = static_cast<size_t>(options.shard);
  // An earlier set in the same folder is not complete any more.
  std::filesystem::remove(path / "dataset.json");
  constexpr size_t kAtOnce = 256;  // crops between two reports of progress
  int number = 0;
  for (size_t begin = 0; begin < count; begin += shard, ++number) {
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
    for (const ShardFile& file : shard_files(number, samples)) {
      write_file_atomically((path / file.name).string(), file.bytes);
    }
  }
  nlohmann::ordered_json json;
  json["format"] = "gable detector dataset 1";
  json["crops"] = count;
  json["shards"] = number;
  json["seed"] = options.seed;
  json["foundations"] = {"I", "II", "III", "L", "U", "C"};
  write_file_atomically((path / "dataset.json").string(), json.dump(2) + "\n");
  return true;
}

}  // namespace gable
