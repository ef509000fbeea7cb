#include <gable/engine/io/readable.h>
#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/height_points.h>
#include <gable/engine/io/scans/las_reader.h>
#include <gable/engine/io/scans/laz_reader.h>
#include <gable/engine/io/scans/obj_reader.h>
#include <gable/engine/io/scans/off_reader.h>
#include <gable/engine/io/scans/pcd_reader.h>
#include <gable/engine/io/scans/ply_reader.h>
#include <gable/engine/io/scans/scan_file.h>
#include <gable/engine/io/scans/whole_file.h>
#include <gable/engine/io/scans/xyz_reader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

namespace gable {
namespace {

using Reader = ScanFile (*)(std::string_view bytes, const std::string& path);

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> kReaders = {
      {".ply", read_ply},
      {".off", read_off},
      {".las", read_las},
      {".laz", read_laz},
      {".obj", read_obj},
      {".pcd", read_pcd},
      {".pwn", read_pwn},
      {".xyz", [](std::string_view bytes,
                  const std::string& path) { return read_xyz(bytes, path, XyzColumns::kUnknown); }},
      {".txt", [](std::string_view bytes,
                  const std::string& path) { return read_xyz(bytes, path, XyzColumns::kUnknown); }},
      {".xyzn",
       [](std::string_view bytes, const std::string& path) {
         return read_xyz(bytes, path, XyzColumns::kNormals);
       }},
  };
  return kReaders;
}

const std::set<std::string> kRasters = {".tif", ".tiff", ".asc", ".vrt"};

std::string known_extensions() {
  std::string known;
  for (const auto& [extension, reader] : readers()) known += " " + extension;
  for (const std::string& extension : kRasters) known += " " + extension;
  return known;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

ScanFile read_scan_file(const std::string& path, const ReadScanOptions& options) {
  const std::string extension = extension_of(path);
  if (kRasters.contains(extension)) return read_height_points(path, options);
  const auto reader = readers().find(extension);
  require_readable(path);
  if (reader == readers().end()) {
    refuse_scan(path, "has no known extension", "known are" + known_extensions());
  }
  const std::string bytes = read_whole_file(path);
  if (bytes.empty()) refuse_scan(path, "is empty", "give a scan with points");
  return reader->second(bytes, path);
}

bool has_scan_extension(const std::string& path) {
  const std::string extension = extension_of(path);
  return readers().contains(extension) || kRasters.contains(extension);
}

Scan read_scan(const std::string& path, const ReadScanOptions& options) {
  return read_scan_file(path, options).scan;
}

}  // namespace gable
