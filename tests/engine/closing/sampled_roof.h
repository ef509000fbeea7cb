#pragma once

#include <gable/engine/closing/height_sample.h>
#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/extrusion.h>

#include <functional>
#include <vector>

namespace gable {

/// Samples on a raster of `gsd` over an outline, at heights with normal noise.
inline std::vector<HeightSample> sample_roof(
    const PlanPolygon& outline, const std::function<double(const Eigen::Vector2d&)>& height,
    double gsd, double noise, uint64_t seed) {
  Random random(seed);
  std::vector<HeightSample> samples;
  Eigen::Vector2d low = outline.outer.front(), high = low;
  for (const Eigen::Vector2d& p : outline.outer) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (double y = low.y() + 0.5 * gsd; y < high.y(); y += gsd) {
    for (double x = low.x() + 0.5 * gsd; x < high.x(); x += gsd) {
      const Eigen::Vector2d p(x, y);
      bool inside = ring_holds(outline.outer, p);
      for (const Ring& hole : outline.holes) inside = inside != ring_holds(hole, p);
      if (!inside) continue;
      const double z = height(p) + (noise > 0.0 ? random.normal(noise) : 0.0);
      samples.push_back({{x, y, z}, gsd * gsd});
    }
  }
  return samples;
}

inline PlanPolygon rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

}  // namespace gable
