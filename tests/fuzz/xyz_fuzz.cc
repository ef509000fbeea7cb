#include <gable/engine/io/scans/xyz_reader.h>

#include "fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  for (const auto columns : {gable::XyzColumns::kNormals, gable::XyzColumns::kUnknown}) {
    const auto reader = [columns](std::string_view bytes, const std::string& path) {
      return gable::read_xyz(bytes, path, columns);
    };
    gable::check_reader(reader, data, size);
  }
  return 0;
}
