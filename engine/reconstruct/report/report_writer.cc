#include <gable/engine/drawing/report_file.h>
#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/reconstruct/report/house_picture.h>
#include <gable/engine/reconstruct/report/report_page.h>
#include <gable/engine/reconstruct/report/report_writer.h>
#include <glog/logging.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <utility>

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxNameLength = 60;
constexpr const char* kPictureFolder = "houses";

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw Error(ExitCode::kCannotWrite, path.string() + ": cannot be written: " + error.message());
}

HousePictureOptions picture_options(const ReportOptions& options) {
  return {options.panel_size, options.residual_range};
}

HouseEntry entry_of(size_t index, const Building& building) {
  HouseEntry entry;
  entry.index = index;
  entry.id = building.id;
  entry.status = building_status_name(building.status);
  entry.reason = building.reason;
  entry.quality = building.quality;
  entry.foundation = foundation_name(building.house ? building.house->foundation : Foundation::kC);
  if (building.house) {
    entry.roofs = roof_list(*building.house);
    entry.dormers = building.house->dormers.size();
    entry.chimneys = building.house->chimneys.size();
    entry.garages = building.house->garages.size();
  }
  entry.picture = std::string(kPictureFolder) + "/" + picture_name(index, building.id);
  return entry;
}

}  // namespace

std::string check(const ReportOptions& options) { return check(picture_options(options)); }

std::string picture_name(size_t index, const std::string& id) {
  char number[24];
  std::snprintf(number, sizeof(number), "%06zu", index);
  std::string name = number;
  name += '-';
  for (const char c : std::string_view(id).substr(0, kMaxNameLength)) {
    const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                      c == '-' || c == '_' || c == '.';
    name += safe ? c : '_';
  }
  return name + ".png";
}

ReportWriter::ReportWriter(const std::string& folder, const ReportOptions& options)
    : folder_(folder), options_(options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<fs::path> missing;
  std::error_code error;
  const std::string staging_name =
      std::string(kPictureFolder) + "." + std::to_string(getpid()) + ".part";
  for (fs::path path = fs::absolute(folder).lexically_normal() / staging_name;
       !fs::exists(path, error) && path.has_relative_path(); path = path.parent_path()) {
    if (path.has_filename()) missing.push_back(path);
  }
  std::reverse(missing.begin(), missing.end());
  for (const fs::path& path : missing) {
    if (!fs::create_directory(path, error) && error) {
      for (auto made = created_.rbegin(); made != created_.rend(); ++made) {
        std::error_code ignored;
        fs::remove(*made, ignored);
      }
      fail(folder_, error);
    }
    created_.push_back(path.string());
  }
  staging_ = (fs::path(folder) / staging_name).string();
}

ReportWriter::~ReportWriter() {
  if (staging_.empty()) return;
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  // Only folders that are empty go, so nothing that somebody else put there is lost.
  for (auto made = created_.rbegin(); made != created_.rend(); ++made) fs::remove(*made, ignored);
}

void ReportWriter::add(size_t index, const Building& building, const HeightImage& image) {
  const HousePicture picture = draw_house_picture(building, image, picture_options(options_));
  write_file_atomically((fs::path(staging_) / picture_name(index, building.id)).string(),
                        png_bytes(picture.image));
  const std::lock_guard lock(mutex_);
  entries_.push_back(entry_of(index, building));
}

void ReportWriter::finish() {
  const std::lock_guard lock(mutex_);
  std::sort(entries_.begin(), entries_.end(),
            [](const HouseEntry& a, const HouseEntry& b) { return a.index < b.index; });
  const fs::path pictures = fs::path(folder_) / kPictureFolder;
  std::error_code error;
  fs::create_directory(pictures, error);
  if (error) fail(pictures, error);
  for (const HouseEntry& entry : entries_) {
    const fs::path target = fs::path(folder_) / entry.picture;
    fs::rename(fs::path(staging_) / target.filename(), target, error);
    if (error) fail(target, error);
  }
  write_file_atomically((fs::path(folder_) / "index.html").string(), report_page(entries_));
  fs::remove_all(std::exchange(staging_, {}), error);
}

}  // namespace gable
