#include <gable/engine/io/scans/lzf.h>

namespace gable {

bool decompress_lzf(std::string_view input, size_t size, std::string* output) {
  output->clear();
  if (size / kLzfGrowth > input.size()) return false;
  output->reserve(size);
  size_t at = 0;
  const auto next = [&] { return static_cast<unsigned char>(input[at++]); };
  while (at < input.size()) {
    const size_t control = next();
    if (control < 32) {
      const size_t length = control + 1;
      if (length > input.size() - at || length > size - output->size()) return false;
      output->append(input.substr(at, length));
      at += length;
      continue;
    }
    size_t length = control >> 5;
    if (length == 7) {
      if (at == input.size()) return false;
      length += next();
    }
    length += 2;
    if (at == input.size()) return false;
    const size_t back = ((control & 31) << 8) + next() + 1;
    if (back > output->size() || length > size - output->size()) return false;
    // Byte by byte: the copy may overlap what it writes.
    for (size_t i = 0; i < length; ++i) output->push_back((*output)[output->size() - back]);
  }
  return output->size() == size;
}

}  // namespace gable
