#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/las_header.h>
#include <gable/engine/io/scans/scalar_type.h>

namespace gable {
namespace {

constexpr int kRecordSizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr int kLastFormat = 10;
constexpr size_t kHeaderSize = 227;  // 1.0 to 1.2
constexpr size_t kHeaderSize14 = 375;
constexpr int kCompressed = 0xC0;  // LAZ marks its point formats with the high bits

}  // namespace

LasHeader read_las_header(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with("LASF")) {
    refuse_scan(path, "is no LAS file: it does not start with LASF", "check the extension");
  }
  if (bytes.size() < kHeaderSize) refuse_scan(path, "ends within its header");
  const char* at = bytes.data();
  const int minor = load<uint8_t>(at + 25);
  const int format = load<uint8_t>(at + 104);
  LasHeader header;
  header.first = load_little<uint32_t>(at + 96);
  header.format = format & ~kCompressed;
  header.compressed = (format & kCompressed) != 0;
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
  if (header.format > kLastFormat) {
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
  return header;
}

}  // namespace gable
