#include <gable/engine/io/scans/pcd_reader.h>

#include "fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, size_t size) {
  return gable::check_reader(gable::read_pcd, data, size);
}
