#include <gable/engine/error.h>
#include <gable/engine/io/staged_folder.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxNames = 1000;

std::vector<std::string> missing_folders(const fs::path& folder) {
  std::vector<std::string> missing;
  std::error_code none;  // what cannot be looked at is found out when it is made
  for (fs::path at = folder; !at.empty() && !fs::exists(at, none); at = at.parent_path()) {
    missing.insert(missing.begin(), at.string());
  }
  return missing;
}

void remove_empty(const std::vector<std::string>& folders) {
  std::error_code ignored;  // a folder that has been filled meanwhile stays
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    fs::remove(*folder, ignored);
  }
}

}  // namespace

StagedFolder::StagedFolder(const std::string& folder) : folder_(folder) {
  const std::vector<std::string> missing = missing_folders(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  for (int i = 0; !error && i < kMaxNames && staging_.empty(); ++i) {
    const fs::path name = ".gable-" + std::to_string(::getpid()) + "-" + std::to_string(i);
    if (fs::create_directory(fs::path(folder) / name, error)) staging_ = fs::path(folder) / name;
  }
  if (staging_.empty()) {
    remove_empty(missing);
    fail(error ? error.message() : "it is full of unfinished files, remove .gable-*");
  }
  made_ = missing;
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  remove_empty(made_);
}

std::string StagedFolder::path(const std::string& name) const {
  return (fs::path(staging_) / name).string();
}

void StagedFolder::commit() {
  std::error_code error;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(staging_, error)) files.push_back(entry.path());
  if (error) fail(error.message());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    fs::rename(file, fs::path(folder_) / file.filename(), error);
    if (error) fail(file.filename().string() + ": " + error.message());
  }
}

void StagedFolder::fail(const std::string& reason) const {
  throw Error(ExitCode::kCannotWrite, folder_ + ": cannot be written: " + reason);
}

}  // namespace gable
