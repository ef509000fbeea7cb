#pragma once

#include <span>
#include <string>
#include <vector>

namespace gable {

/// The header of an NPY file (format 1.0) of the given element type and shape, row-major: `type` as
/// NumPy writes it, little-endian, for instance "|u1", "|i1" or "<f4".
std::string npy_header(const std::string& type, const std::vector<size_t>& shape);

/// A whole NPY file of bytes, of small signed numbers, or of floats. The values fill the shape.
std::string npy_file(std::span<const unsigned char> values, const std::vector<size_t>& shape);
std::string npy_file(std::span<const signed char> values, const std::vector<size_t>& shape);
std::string npy_file(std::span<const float> values, const std::vector<size_t>& shape);

}  // namespace gable
