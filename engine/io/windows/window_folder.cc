#include <fcntl.h>
#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/content_hash.h>
#include <gable/engine/io/windows/window_folder.h>
#include <glog/logging.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr const char* kManifest = "manifest.json";
constexpr const char* kFilePrefix = "window_";
constexpr const char* kFileSuffix = ".city.jsonl";
constexpr const char* kUnfinished = ".part";  // as AtomicFile names them

}  // namespace

WindowFolder::WindowFolder(const std::string& folder, WindowManifest manifest,
                           const ModelWriterOptions& options, bool resume)
    : folder_(folder), manifest_(std::move(manifest)), options_(options) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!error && !fs::is_directory(folder_, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    throw Error(ExitCode::kCannotWrite, folder_ + ": cannot be written: " + error.message());
  }
  lock();
  try {
    if (fs::exists(path_of(kManifest), error)) take_over(resume);
    remove_unfinished();
    write_manifest();
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

WindowFolder::~WindowFolder() { ::close(lock_); }

/// The system gives the lock back however the program ends.
void WindowFolder::lock() {
  lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) {
    throw Error(ExitCode::kCannotWrite, folder_ + ": cannot be written: " + std::strerror(errno));
  }
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(lock_);
  throw Error(ExitCode::kUsage,
              folder_ + ": another run is at work there; wait for it, or give another folder");
}

/// Takes over the windows that are done and whose files are as they were written.
void WindowFolder::take_over(bool resume) {
  const WindowManifest before = read_manifest(path_of(kManifest));
  const bool nothing_to_lose =
      std::none_of(before.windows.begin(), before.windows.end(),
                   [](const ManifestWindow& window) { return window.done; });
  if (nothing_to_lose) return;
  if (!resume) {
    throw Error(ExitCode::kUsage,
                folder_ +
                    ": holds models already; go on with --resume, give another folder with "
                    "-o, or remove it");
  }
  if (const std::string what = difference(manifest_, before); !what.empty()) {
    throw Error(ExitCode::kUsage, path_of(kManifest) + ": cannot be resumed, " + what +
                                      "; give the same inputs and options, or another folder "
                                      "with -o");
  }
  for (size_t i = 0; i < before.windows.size(); ++i) {
    const ManifestWindow& window = before.windows[i];
    if (!window.done) continue;
    std::error_code none;
    const std::string file = path_of(window.file);
    if (!window.file.empty() &&
        (window.file != fs::path(window.file).filename() || !fs::is_regular_file(file, none) ||
         hash_of_file(file) != window.hash)) {
      continue;
    }
    manifest_.windows[i] = window;
  }
}

void WindowFolder::remove_unfinished() const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(kUnfinished)) continue;
    if (!name.starts_with(kFilePrefix) && !name.starts_with(kManifest)) continue;
    std::error_code ignored;  // a file that cannot be removed is in nobody's way
    fs::remove(entry.path(), ignored);
  }
}

void WindowFolder::write_manifest() const {
  write_file_atomically(path_of(kManifest), manifest_text(manifest_));
}

std::string WindowFolder::path_of(const std::string& name) const {
  return (fs::path(folder_) / name).string();
}

void WindowFolder::append(size_t window, const Building& building, const BuildingModel& model) {
  CHECK(!is_done(window));
  if (!writer_) {
    writer_ = open_model_writer(path_of(kFilePrefix + manifest_.windows[window].name + kFileSuffix),
                                options_);
  }
  writer_->append(building, model);
  ++buildings_[building_status_name(building.status)];
}

void WindowFolder::finish(size_t window, const ManifestWindow& counts) {
  ManifestWindow& record = manifest_.windows[window];
  CHECK(!record.done);
  record.small = counts.small;
  record.crowns = counts.crowns;
  record.far = counts.far;
  record.unexplained = counts.unexplained;
  record.buildings = std::exchange(buildings_, {});
  if (writer_) {
    record.file = kFilePrefix + record.name + kFileSuffix;
    writer_->close();
    writer_.reset();
    record.hash = hash_of_file(path_of(record.file));
  }
  record.done = true;
  write_manifest();
}

}  // namespace gable
