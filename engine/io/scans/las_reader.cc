#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/las_reader.h>
#include <gable/engine/io/scans/scalar_type.h>

#include <climits>

namespace gable {
namespace {

constexpr int kRecordSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr size_t kHeaderSize = 227;  // 1.0 to 1.2
constexpr size_t kHeaderSize14 = 375;
constexpr int kCompressed = 0xC0;  // LAZ marks its point formats with the high bits

struct Header {
  size_t first = 0;  ///< offset of the first record
  size_t count = 0;
  size_t record_size = 0;
  int format = 0;
  Eigen::Vector3d scale;
  Eigen::Vector3d offset;
};

Header read_header(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with("LASF")) {
    refuse_scan(path, "is no LAS file: it does not start with LASF", "check the extension");
  }
  if (bytes.size() < kHeaderSize) refuse_scan(path, "ends within its header");
  const char* at = bytes.data();
  const int minor = load<uint8_t>(at + 25);
  Header header;
  header.first = load_little<uint32_t>(at + 96);
  header.format = load<uint8_t>(at + 104);
  header.record_size = load_little<uint16_t>(at + 105);
  header.count = load_little<uint32_t>(at + 107);
  for (int k = 0; k < 3; ++k) {
    header.scale[k] = load_little<double>(at + 131 + 8 * k);
    header.offset[k] = load_little<double>(at + 155 + 8 * k);
  }
  if (minor >= 4) {
    if (bytes.size() < kHeaderSize14) refuse_scan(path, "ends within its header");
    if (header.count == 0) header.count = load_little<uint64_t>(at + 247);
  }
  if (header.format & kCompressed) {
    refuse_scan(path, "its points are compressed (LAZ)", "name it .laz, or convert it to LAS");
  }
  if (header.format > 10) {
    refuse_scan(path, "has the unknown point format " + std::to_string(header.format),
                "convert it to LAS 1.4");
  }
  if (header.record_size < static_cast<size_t>(kRecordSizes[header.format])) {
    refuse_scan(path, "its points have " + std::to_string(header.record_size) +
                          " bytes, too few for point format " + std::to_string(header.format));
  }
  if (!header.scale.allFinite() || !header.offset.allFinite() ||
      (header.scale.array() == 0.0).any()) {
    refuse_scan(path, "its scale or offset is no usable number");
  }
  const size_t held =
      header.first <= bytes.size() ? (bytes.size() - header.first) / header.record_size : 0;
  if (header.count > held || header.count > INT_MAX) {
    refuse_scan(
        path,
        "announces " + std::to_string(header.count) + " points, but holds " + std::to_string(held),
        "the file is truncated or damaged, export it again");
  }
  return header;
}

}  // namespace

ScanFile read_las(std::string_view bytes, const std::string& path) {
  const Header header = read_header(bytes, path);
  Scan scan;
  scan.points.resize(header.count);
  std::vector<int>& classes = scan.labels["class"];
  classes.resize(header.count);
  for (size_t i = 0; i < header.count; ++i) {
    const char* record = bytes.data() + header.first + i * header.record_size;
    for (int k = 0; k < 3; ++k) {
      scan.points[i][k] = load_little<int32_t>(record + 4 * k) * header.scale[k] + header.offset[k];
    }
    classes[i] = header.format < 6 ? load<uint8_t>(record + 15) & 31 : load<uint8_t>(record + 16);
  }
  return finish_scan(std::move(scan), path);
}

}  // namespace gable
