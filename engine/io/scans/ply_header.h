#pragma once

#include <gable/engine/io/scans/scalar_type.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;  ///< of a list: of its entries
  bool is_list = false;
  ScalarType length_type = ScalarType::kUint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  size_t size = 0;  ///< bytes up to and with the end of the line "end_header"
};

/// Reads the header of a PLY file. Throws Error (kBadInput), naming `path`, where it is none, or
/// where it announces more than the bytes behind it can hold.
PlyHeader read_ply_header(std::string_view bytes, const std::string& path);

}  // namespace gable
