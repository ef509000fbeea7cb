#pragma once

#include <gable/engine/scan.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

/// A small scan whose numbers every format can hold: five points with normals, two facets (a
/// triangle and a quadrilateral), labels "plane".
Scan sample_cloud();
Scan sample_mesh();

/// The samples as files of each format, written for the tests alone. `format` is that of the
/// header's line.
std::string ply_file(const Scan& scan, const std::string& format);
std::string xyz_file(const Scan& scan, bool normals);
std::string pwn_file(const Scan& scan);
std::string off_file(const Scan& scan);
std::string obj_file(const Scan& scan);
std::string las_file(const Scan& scan, int minor, int point_format);
/// `data`: ascii, binary or binary_compressed.
std::string pcd_file(const Scan& scan, const std::string& data);

/// Appends the bytes of a number.
template <typename T>
void append_bytes(T value, std::string* bytes, std::endian order = std::endian::little) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (order != std::endian::native) std::reverse(raw, raw + sizeof(T));
  bytes->append(raw, sizeof(T));
}

/// `text` with the first `from` replaced by `to`, which must be there.
std::string with(std::string text, std::string_view from, std::string_view to);

}  // namespace gable
