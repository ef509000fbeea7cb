#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

/// A class of objects that surfaces can be made of.
struct ObjectClass {
  std::string name;                             ///< "buildings"
  LabelledSurface (*random_surface)(uint64_t);  ///< by seed
};

/// All of them: buildings, indoor, cars, sofas.
const std::vector<ObjectClass>& object_classes();

}  // namespace gable
