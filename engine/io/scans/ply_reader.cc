#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/ply_header.h>
#include <gable/engine/io/scans/ply_reader.h>
#include <gable/engine/io/scans/text_cursor.h>

#include <array>
#include <bit>
#include <cmath>
#include <set>

namespace gable {
namespace {

/// The values behind a binary header, one after the other.
class BinaryBody {
 public:
  BinaryBody(std::string_view bytes, const std::string& path, bool swapped)
      : bytes_(bytes), path_(path), swapped_(swapped) {}
  double next(ScalarType type) {
    const size_t size = size_of(type);
    if (bytes_.size() < size) refuse("is truncated");
    const double value = load_scalar(type, bytes_.data(), swapped_);
    bytes_.remove_prefix(size);
    return value;
  }
  bool can_hold(double count, ScalarType type) const {
    return count * size_of(type) <= static_cast<double>(bytes_.size());
  }
  void skip_list(int64_t count, ScalarType type) { bytes_.remove_prefix(count * size_of(type)); }
  [[noreturn]] void refuse(const std::string& problem) const { refuse_scan(path_, problem); }

 private:
  std::string_view bytes_;
  const std::string& path_;
  bool swapped_;
};

/// The same of text.
class TextBody {
 public:
  explicit TextBody(TextCursor* cursor) : cursor_(*cursor) {}
  double next(ScalarType) { return cursor_.number("a value"); }
  bool can_hold(double count, ScalarType) const {
    return count * 2 <= static_cast<double>(cursor_.bytes_left()) + 1;
  }
  void skip_list(int64_t count, ScalarType type) {
    for (int64_t i = 0; i < count; ++i) next(type);
  }
  [[noreturn]] void refuse(const std::string& problem) const { cursor_.refuse(problem); }

 private:
  TextCursor& cursor_;
};

bool is_colour(const std::string& name) {
  static const std::set<std::string, std::less<>> kColours = {"red", "green", "blue", "alpha",
                                                              "r",   "g",     "b",    "a"};
  const size_t prefix = name.find('_');  // diffuse_red
  return kColours.contains(name) ||
         (prefix != std::string::npos && kColours.contains(name.substr(prefix + 1)));
}

using Labels = std::map<std::string, std::vector<int>>;

template <typename Body>
int64_t read_length(Body* body, const PlyProperty& list) {
  const double length = body->next(list.length_type);
  if (!(length >= 0.0) || length != std::floor(length) || !body->can_hold(length, list.type)) {
    body->refuse("a list has more entries than the file can hold");
  }
  return static_cast<int64_t>(length);
}

/// Where a property of an element goes; nowhere where both are unset.
struct Destination {
  int slot = -1;  ///< x y z nx ny nz
  std::vector<int>* label = nullptr;
};

constexpr std::array<const char*, 6> kSlots = {"x", "y", "z", "nx", "ny", "nz"};

std::vector<Destination> destinations(const PlyElement& element, bool with_slots, Labels* labels) {
  std::vector<Destination> out(element.properties.size());
  std::array<bool, 6> taken{};
  for (size_t p = 0; p < out.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list) continue;
    bool is_slot = false;
    for (int k = 0; with_slots && k < 6; ++k) {
      if (property.name != kSlots[k]) continue;
      is_slot = true;
      if (!taken[k]) out[p].slot = k;
      taken[k] = true;
    }
    if (is_slot || !is_integer(property.type) || is_colour(property.name)) continue;
    const auto [label, is_new] = labels->try_emplace(property.name);
    if (!is_new) continue;
    label->second.reserve(element.count);
    out[p].label = &label->second;
  }
  return out;
}

bool has_property(const PlyElement& element, std::string_view name) {
  for (const PlyProperty& property : element.properties) {
    if (property.name == name && !property.is_list) return true;
  }
  return false;
}

template <typename Body>
void read_vertices(const PlyElement& element, const std::string& path, Body* body, Scan* scan,
                   Labels* labels) {
  for (const char* name : {"x", "y", "z"}) {
    if (!has_property(element, name)) {
      refuse_scan(path, std::string("its vertices have no property ") + name,
                  "export coordinates as x y z");
    }
  }
  const bool normals =
      has_property(element, "nx") && has_property(element, "ny") && has_property(element, "nz");
  const auto to = destinations(element, true, labels);
  scan->points.resize(element.count);
  if (normals) scan->normals.resize(element.count);
  std::array<double, 6> values{};
  for (size_t i = 0; i < element.count; ++i) {
    for (size_t p = 0; p < to.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list) {
        body->skip_list(read_length(body, property), property.type);
        continue;
      }
      const double value = body->next(property.type);
      if (to[p].slot >= 0) values[to[p].slot] = value;
      if (to[p].label) to[p].label->push_back(label_of(value));
    }
    scan->points[i] = {values[0], values[1], values[2]};
    if (normals) {
      scan->normals[i] = Eigen::Vector3d(values[3], values[4], values[5]).cast<float>();
    }
  }
}

/// The corners of a face; a corner that is no point of any file becomes -1.
template <typename Body>
void read_corners(Body* body, const PlyProperty& list, std::vector<int>* corners) {
  corners->resize(read_length(body, list));
  for (int& corner : *corners) corner = label_of(body->next(list.type));
}

template <typename Body>
void read_faces(const PlyElement& element, Body* body, Scan* scan, Labels* labels) {
  const auto to = destinations(element, false, labels);
  size_t list = to.size();
  for (size_t p = to.size(); p-- > 0;) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list &&
        (property.name == "vertex_indices" || property.name == "vertex_index")) {
      list = p;
    }
  }
  std::vector<int> corners;
  for (size_t i = 0; i < element.count; ++i) {
    corners.clear();
    for (size_t p = 0; p < to.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p == list) {
        read_corners(body, property, &corners);
      } else if (property.is_list) {
        body->skip_list(read_length(body, property), property.type);
      } else {
        const double value = body->next(property.type);
        if (to[p].label) to[p].label->push_back(label_of(value));
      }
    }
    scan->facets.add(corners);
  }
}

template <typename Body>
void skip_element(const PlyElement& element, Body* body) {
  if (element.properties.empty()) return;
  for (size_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      const int64_t count = property.is_list ? read_length(body, property) : 1;
      if (!body->can_hold(static_cast<double>(count), property.type)) body->refuse("is truncated");
      body->skip_list(count, property.type);
    }
  }
}

template <typename Body>
Scan read_body(const PlyHeader& header, const std::string& path, Body* body) {
  Scan scan;
  Labels of_vertices, of_faces;
  bool has_vertices = false, has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex" && !has_vertices) {
      read_vertices(element, path, body, &scan, &of_vertices);
      has_vertices = true;
    } else if (element.name == "face" && !has_faces && !element.properties.empty()) {
      read_faces(element, body, &scan, &of_faces);
      has_faces = true;
    } else {
      skip_element(element, body);
    }
  }
  if (!has_vertices) refuse_scan(path, "has no element vertex", "export points or a mesh");
  scan.labels = std::move(scan.is_mesh() ? of_faces : of_vertices);
  return scan;
}

}  // namespace

ScanFile read_ply(std::string_view bytes, const std::string& path) {
  const PlyHeader header = read_ply_header(bytes, path);
  if (header.format == PlyFormat::kAscii) {
    TextCursor cursor(bytes, path);
    cursor.skip(header.size);
    TextBody body(&cursor);
    return finish_scan(read_body(header, path, &body), path);
  }
  const bool little = header.format == PlyFormat::kLittleEndian;
  const bool swapped = little != (std::endian::native == std::endian::little);
  BinaryBody body(bytes.substr(header.size), path, swapped);
  return finish_scan(read_body(header, path, &body), path);
}

}  // namespace gable
