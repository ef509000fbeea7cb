#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/shapes/labelled_ply.h>
#include <glog/logging.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

namespace gable {
namespace {

template <typename T>
void append(T value, std::string* bytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (std::endian::native == std::endian::big) std::reverse(raw, raw + sizeof(T));
  bytes->append(raw, sizeof(T));
}

struct Property {
  std::string name;
  std::span<const int> of_element;
};

std::string header(const Scan& scan, const std::vector<Property>& properties) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment gable: metres, z up\n";
  text += "element vertex " + std::to_string(scan.points.size()) + "\n";
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!scan.normals.empty()) text += "property float nx\nproperty float ny\nproperty float nz\n";
  if (scan.is_mesh()) {
    text += "element face " + std::to_string(scan.facets.size()) + "\n";
    text += "property list int int vertex_indices\n";
  }
  for (const Property& property : properties) text += "property int " + property.name + "\n";
  return text + "end_header\n";
}

void write_ply(const std::string& path, const Scan& scan, const std::vector<Property>& properties) {
  for (const Property& p : properties) CHECK_EQ(p.of_element.size(), scan.num_elements());
  CHECK(scan.normals.empty() || scan.normals.size() == scan.points.size());
  constexpr size_t kChunk = size_t{1} << 20;
  AtomicFile file(path);
  std::string bytes = header(scan, properties);
  const auto flush = [&](size_t limit) {
    if (bytes.size() < limit) return;
    file.write(bytes);
    bytes.clear();
  };
  const auto append_properties = [&](size_t element) {
    for (const Property& property : properties) append(property.of_element[element], &bytes);
  };
  for (size_t i = 0; i < scan.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) append(scan.points[i][k], &bytes);
    for (int k = 0; k < 3 && !scan.normals.empty(); ++k) append(scan.normals[i][k], &bytes);
    if (!scan.is_mesh()) append_properties(i);
    flush(kChunk);
  }
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    append(static_cast<int>(scan.facets[f].size()), &bytes);
    for (const int corner : scan.facets[f]) append(corner, &bytes);
    append_properties(f);
    flush(kChunk);
  }
  flush(0);
  file.commit();
}

}  // namespace

void write_labelled_ply(const std::string& path, const Scan& scan, std::span<const int> shape_of) {
  write_ply(path, scan, {{"shape", shape_of}});
}

void write_scan_ply(const std::string& path, const Scan& scan) {
  std::vector<Property> properties;
  for (const auto& [name, values] : scan.labels) properties.push_back({name, values});
  write_ply(path, scan, properties);
}

}  // namespace gable
