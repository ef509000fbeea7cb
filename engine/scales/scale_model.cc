#include <gable/engine/scales/scale_chain.h>
#include <gable/engine/scales/scale_model.h>

#include <algorithm>

namespace gable {

std::string check(const ScaleModel& model) {
  if (model.name.empty() || model.name.size() > 100) return "the name must have 1 to 100 bytes";
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  if (std::any_of(model.name.begin(), model.name.end(), control)) {
    return "the name must not have control characters";
  }
  const std::string chain = check(ScaleChainOptions{model.gamma});
  if (!chain.empty()) return chain;
  if (model.num_scales() < 1) return "there must be at least one scale";
  return check(model.forest);
}

}  // namespace gable
