#include <gable/engine/reconstruct/building/model_defect.h>

#include <algorithm>

namespace gable {

std::string defect_of(const BuildingModel& model) {
  const bool body = std::any_of(model.parts.begin(), model.parts.end(), [](const PartModel& part) {
    return part.role == PartRole::kMain && part.solids.back().lod == Lod::k22;
  });
  for (const std::string& line : model.dropped) {
    if (line.find("no valid solid") != std::string::npos) return line;
  }
  return body ? "" : "the house has no body";
}

}  // namespace gable
