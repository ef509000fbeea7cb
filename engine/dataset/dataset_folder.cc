#include <gable/engine/dataset/dataset_folder.h>
#include <gable/engine/dataset/shard.h>
#include <gable/engine/io/atomic_file.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

namespace gable {
namespace {

std::string in_folder(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

DatasetFolder::DatasetFolder(const std::string& folder, const std::string& source)
    : folder_(folder), source_(source) {
  std::error_code none;
  std::filesystem::remove(in_folder(folder, "dataset.json"), none);
}

void DatasetFolder::append(const std::vector<TrainingSample>& samples) {
  for (const ShardFile& file : shard_files(shards_, samples)) {
    write_file_atomically(in_folder(folder_, file.name), file.bytes);
  }
  count_ += samples.size();
  ++shards_;
}

void DatasetFolder::close() {
  nlohmann::ordered_json json;
  json["format"] = "gable detector dataset 1";
  json["source"] = source_;
  json["crops"] = count_;
  json["shards"] = shards_;
  json["foundations"] = {"I", "II", "III", "L", "U", "C"};
  write_file_atomically(in_folder(folder_, "dataset.json"), json.dump(2) + "\n");
}

}  // namespace gable
