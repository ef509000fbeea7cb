#include <gable/engine/reconstruct/heights/measured_heights.h>

namespace gable {

std::vector<float> measured_heights(const HeightImage& image) {
  std::vector<float> heights;
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.inside[i] && is_evidence(image, i)) heights.push_back(image.height[i]);
  }
  return heights;
}

}  // namespace gable
