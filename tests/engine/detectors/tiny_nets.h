#pragma once

#include <gable/engine/detectors/detector_nets.h>

#include "engine/detectors/tiny_onnx.h"
#include "engine/io/scratch.h"

namespace gable {

/// Writes three tiny networks, which know nothing of houses, into a folder.
inline void write_tiny_nets(const ScratchFolder& folder) {
  folder.write(kHouseNet, tiny_house_net());
  folder.write(kRoofNet, tiny_roof_net());
  folder.write(kAzimuthNet, tiny_azimuth_net());
}

}  // namespace gable
