#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/las_header.h>
#include <gable/engine/io/scans/las_reader.h>
#include <gable/engine/io/scans/scalar_type.h>

#include <climits>

namespace gable {
ScanFile read_las(std::string_view bytes, const std::string& path) {
  const LasHeader header = read_las_header(bytes, path);
  if (header.compressed) {
    refuse_scan(path, "its points are compressed (LAZ)", "name it .laz, or convert it to LAS");
  }
  const size_t held =
      header.first <= bytes.size() ? (bytes.size() - header.first) / header.record_size : 0;
  if (header.count > held || header.count > INT_MAX) {
    refuse_scan(
        path,
        "announces " + std::to_string(header.count) + " points, but holds " + std::to_string(held),
        "the file is truncated or damaged, export it again");
  }
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
