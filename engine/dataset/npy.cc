#include <gable/engine/dataset/npy.h>
#include <glog/logging.h>

#include <bit>
#include <cstring>
#include <functional>
#include <numeric>

namespace gable {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie");

template <typename T>
std::string file_of(const std::string& type, std::span<const T> values,
                    const std::vector<size_t>& shape) {
  CHECK_EQ(values.size(),
           std::accumulate(shape.begin(), shape.end(), size_t{1}, std::multiplies<>()));
  std::string file = npy_header(type, shape);
  const size_t at = file.size();
  file.resize(at + values.size_bytes());
  if (!values.empty()) std::memcpy(file.data() + at, values.data(), values.size_bytes());
  return file;
}

}  // namespace

std::string npy_header(const std::string& type, const std::vector<size_t>& shape) {
  std::string text = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (";
  for (const size_t size : shape) text += std::to_string(size) + ", ";
  text += "), }";
  // Magic, version, the length's two bytes and the text fill a multiple of 64 bytes.
  constexpr size_t kBefore = 10, kAlign = 64;
  const size_t total = (kBefore + text.size() + 1 + kAlign - 1) / kAlign * kAlign;
  text.append(total - kBefore - text.size() - 1, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 0xff);
  header += static_cast<char>(text.size() >> 8);
  return header + text;
}

std::string npy_file(std::span<const unsigned char> values, const std::vector<size_t>& shape) {
  return file_of("|u1", values, shape);
}

std::string npy_file(std::span<const signed char> values, const std::vector<size_t>& shape) {
  return file_of("|i1", values, shape);
}

std::string npy_file(std::span<const float> values, const std::vector<size_t>& shape) {
  return file_of("<f4", values, shape);
}

}  // namespace gable
