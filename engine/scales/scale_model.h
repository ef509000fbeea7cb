#pragma once

#include <gable/engine/scales/forest.h>

#include <string>

namespace gable {

/// What has been learned of the structural scales of a class of objects.
struct ScaleModel {
  std::string name;    ///< of the class, for people: 1 to 100 bytes, no control characters
  double gamma = 0.5;  ///< of the chain, see ScaleChainOptions
  Forest forest;       ///< labels 0 (before the first scale) to num_scales()

  int num_scales() const { return forest.num_labels - 1; }
  bool operator==(const ScaleModel&) const = default;
};

/// Empty if the model is sound; otherwise says what is not.
std::string check(const ScaleModel& model);

}  // namespace gable
