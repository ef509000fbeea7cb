#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/engine/reconstruct/first_values/block_search.h>
#include <gable/engine/reconstruct/first_values/classical_values.h>
#include <gable/engine/reconstruct/heights/rectified_view.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

// Directions nearer than this are one, radians.
constexpr double kSeparation = 7.0 * M_PI / 180.0;

}  // namespace

std::vector<FirstValue> classical_values(const HeightImage& image, int per_foundation) {
  const auto inside = static_cast<double>(std::count(image.inside.begin(), image.inside.end(), 1));
  const double cell = std::max({image.gsd, 0.5, std::sqrt(inside * image.gsd * image.gsd) / 60.0});
  const OriginsByKind origins = {"where outline and roof rise", "lines of steps in the heights",
                                 "regression over the rectangle's cells", "", ""};
  std::vector<FirstValue> values;
  for (const AzimuthCandidate& azimuth : azimuth_candidates(image, kSeparation)) {
    const RectifiedView view = rectify(image, azimuth.azimuth, cell, 1.5);
    BlockSearchOptions search;
    search.per_foundation = per_foundation;
    for (Hypothesis& hypothesis : search_blocks(view, image.origin, search)) {
      FirstValue value;
      value.origins = origins_of(hypothesis.house, origins);
      value.house = std::move(hypothesis.house);
      value.source = ValueSource::kClassical;
      values.push_back(std::move(value));
    }
  }
  return values;
}

}  // namespace gable
