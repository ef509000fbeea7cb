#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/ogr_crs.h>
#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/las_points.h>
#include <gable/engine/io/scans/laz_reader.h>
#include <gable/engine/io/scans/scalar_type.h>
#include <gable/engine/io/scans/whole_file.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace gable {
namespace {

constexpr size_t kHeaderSize = 375;  // that of LAS 1.4, the longest
constexpr size_t kPieceSize = size_t{1} << 20;
constexpr size_t kRecordHeaderSize = 54;  // of a variable length record
constexpr size_t kMostRecordBytes = size_t{1} << 26;
constexpr int kWktRecord = 2112;
constexpr int kGeoKeysRecord = 34735;
constexpr int kProjectedCrsKey = 3072;
constexpr int kUserDefined = 32767;

/// The file from its beginning, with its header.
struct LasFile {
  std::ifstream stream;
  uint64_t size = 0;
  std::string head;
  LasHeader header;
};

LasFile open_las(const std::string& path) {
  LasFile file;
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    throw Error(ExitCode::kNoInput, path + ": no such file; check the path");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error(ExitCode::kNoInput, path + ": is no file; give a LAS or LAZ file");
  }
  file.size = std::filesystem::file_size(path, error);
  file.stream.open(path, std::ios::binary);
  if (!file.stream || error) {
    throw Error(ExitCode::kNoInput, path + ": cannot be read: " + std::strerror(errno));
  }
  file.head.resize(kHeaderSize);
  file.stream.read(file.head.data(), static_cast<std::streamsize>(kHeaderSize));
  file.head.resize(static_cast<size_t>(file.stream.gcount()));
  file.stream.clear();
  file.header = read_las_header(file.head, path);
  return file;
}

void visit_plain_points(LasFile* file, const std::string& path,
                        const std::function<void(const LasPoint&)>& visit) {
  const LasHeader& header = file->header;
  const uint64_t held =
      header.first <= file->size ? (file->size - header.first) / header.record_size : 0;
  if (header.count > held) {
    refuse_scan(
        path,
        "announces " + std::to_string(header.count) + " points, but holds " + std::to_string(held),
        "the file is truncated or damaged, export it again");
  }
  const size_t per_piece = std::max<size_t>(1, kPieceSize / header.record_size);
  std::vector<char> piece(per_piece * header.record_size);
  file->stream.seekg(static_cast<std::streamoff>(header.first));
  for (uint64_t done = 0; done < header.count;) {
    const size_t count = std::min<uint64_t>(per_piece, header.count - done);
    const auto size = static_cast<std::streamsize>(count * header.record_size);
    if (!file->stream.read(piece.data(), size)) refuse_scan(path, "its points cannot be read");
    for (size_t i = 0; i < count; ++i) {
      const char* record = piece.data() + i * header.record_size;
      LasPoint point;
      for (int k = 0; k < 3; ++k) {
        point.position[k] =
            load_little<int32_t>(record + 4 * k) * header.scale[k] + header.offset[k];
      }
      if (header.format < 6) {
        const uint8_t byte = load<uint8_t>(record + 15);
        point.classification = byte & 31;
        point.withheld = (byte & 128) != 0;
      } else {
        point.classification = load<uint8_t>(record + 16);
        point.withheld = (load<uint8_t>(record + 15) & 4) != 0;
      }
      if (point.position.allFinite()) visit(point);
    }
    done += count;
  }
}

/// The EPSG code of the projected system among GeoTIFF keys, or 0.
int projected_code(std::string_view keys) {
  const auto word = [&](size_t i) { return int{load_little<uint16_t>(keys.data() + 2 * i)}; };
  for (size_t entry = 4; 2 * (entry + 4) <= keys.size(); entry += 4) {
    const bool value_is_here = word(entry + 1) == 0;
    if (word(entry) == kProjectedCrsKey && value_is_here && word(entry + 3) != kUserDefined) {
      return word(entry + 3);
    }
  }
  return 0;
}

[[noreturn]] void refuse_crs(const std::string& path) {
  refuse_scan(path, "names a reference system that is none", "convert it anew with a valid one");
}

/// Of what stands in a file only WKT is understood, no name of a file or an address.
Crs crs_from_wkt(const std::string& wkt, const std::string& path) {
  const GdalMessages messages;
  OGRSpatialReference srs;
  if (srs.importFromWkt(wkt.c_str()) != OGRERR_NONE) refuse_crs(path);
  return crs_from_ogr(srs);
}

Crs crs_from_code(int code, const std::string& path) {
  const GdalMessages messages;
  OGRSpatialReference srs;
  if (srs.importFromEPSG(code) != OGRERR_NONE) refuse_crs(path);
  return crs_from_ogr(srs);
}

}  // namespace

void visit_las_points(const std::string& path, const std::function<void(const LasPoint&)>& visit) {
  LasFile file = open_las(path);
  if (!file.header.compressed) return visit_plain_points(&file, path, visit);
  file.stream.close();
  visit_laz_points(read_whole_file(path), path, visit);
}

Crs read_las_crs(const std::string& path) {
  LasFile file = open_las(path);
  const size_t begin = load_little<uint16_t>(file.head.data() + 94);
  const auto count = load_little<uint32_t>(file.head.data() + 100);
  if (file.header.first < begin) refuse_scan(path, "its points begin within its header");
  std::string records(std::min<uint64_t>({file.header.first - begin, file.size, kMostRecordBytes}),
                      '\0');
  file.stream.seekg(static_cast<std::streamoff>(begin));
  file.stream.read(records.data(), static_cast<std::streamsize>(records.size()));
  records.resize(static_cast<size_t>(file.stream.gcount()));
  int code = 0;
  size_t at = 0;
  for (uint32_t i = 0; i < count && at + kRecordHeaderSize <= records.size(); ++i) {
    const int id = load_little<uint16_t>(records.data() + at + 18);
    const size_t size = load_little<uint16_t>(records.data() + at + 20);
    const std::string_view user(records.data() + at + 2, 16);
    at += kRecordHeaderSize;
    const std::string_view data = std::string_view(records).substr(at, size);
    at += data.size();
    if (!user.starts_with("LASF_Projection")) continue;
    if (id == kWktRecord) {
      const std::string text(data.substr(0, data.find('\0')));
      if (!text.empty()) return crs_from_wkt(text, path);
    }
    if (id == kGeoKeysRecord) code = projected_code(data);
  }
  return code > 0 ? crs_from_code(code, path) : Crs();
}

}  // namespace gable
