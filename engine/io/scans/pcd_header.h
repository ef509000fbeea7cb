#pragma once

#include <gable/engine/io/scans/scalar_type.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::kFloat32;
  size_t count = 1;   ///< values per point
  size_t offset = 0;  ///< of the first value, in the bytes of a point
  size_t column = 0;  ///< of the first value, in the words of a point
  size_t size() const { return count * size_of(type); }
};

enum class PcdData { kAscii, kBinary, kCompressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  size_t num_points = 0;
  size_t point_size = 0;   ///< bytes
  size_t num_columns = 0;  ///< words per point
  PcdData data = PcdData::kAscii;
  size_t size = 0;  ///< bytes up to and with the end of the line "DATA"
};

/// Reads the header of a PCD file. Throws Error (kBadInput), naming `path`, where it is none. The
/// number of points is as announced, not yet checked against the size of the file.
PcdHeader read_pcd_header(std::string_view bytes, const std::string& path);

}  // namespace gable
