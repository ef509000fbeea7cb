#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>

namespace gable {

/// What the public header of a LAS or LAZ file says of its points (ASPRS LAS specification 1.4 R15,
/// table 3).
struct LasHeader {
  size_t first = 0;        ///< offset of the first record, or of compressed points
  size_t count = 0;        ///< points
  size_t record_size = 0;  ///< bytes, when not compressed
  int format = 0;          ///< point format, 0 to 10
  bool compressed = false;
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// Throws Error (kBadInput), naming `path`, where the header is none or cannot be used. Offsets and
/// counts are as announced, not yet checked against the size of the file.
LasHeader read_las_header(std::string_view bytes, const std::string& path);

}  // namespace gable
