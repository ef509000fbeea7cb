#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/labelled_ply.h>
#include <glog/logging.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace gable {
namespace {

template <typename T>
void append(T value, std::string* bytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof(T));
  bytes->append(raw, sizeof(T));
}

std::string header(const Scan& scan) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment gable: metres, z up\n";
  text += "element vertex " + std::to_string(scan.points.size()) + "\n";
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!scan.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (scan.is_mesh()) {
    text += "element face " + std::to_string(scan.facets.size()) + "\n";
    text += "property list int int vertex_indices\n";
  }
  return text + "property int shape\nend_header\n";
}

}  // namespace

void write_labelled_ply(const std::string& path, const Scan& scan, std::span<const int> shape_of) {
  CHECK_EQ(shape_of.size(), scan.num_elements());
  CHECK(scan.normals.empty() || scan.normals.size() == scan.points.size());
  constexpr size_t kChunk = size_t{1} << 20;
  AtomicFile file(path);
  std::string bytes = header(scan);
  const auto flush = [&](size_t limit) {
    if (bytes.size() < limit) return;
    file.write(bytes);
    bytes.clear();
  };
  for (size_t i = 0; i < scan.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) append(scan.points[i][k], &bytes);
    for (int k = 0; k < 3 && !scan.normals.empty(); ++k) append(scan.normals[i][k], &bytes);
    if (!scan.is_mesh()) append(shape_of[i], &bytes);
    flush(kChunk);
  }
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    append(static_cast<int>(scan.facets[f].size()), &bytes);
    for (const int corner : scan.facets[f]) append(corner, &bytes);
    append(shape_of[f], &bytes);
    flush(kChunk);
  }
  flush(0);
  file.commit();
}

}  // namespace gable
