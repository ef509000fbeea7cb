#include <gable/engine/reconstruct/overhangs.h>

#include <array>
#include <cmath>

namespace gable {
namespace {

// How far inside a wall its roof is looked for, in reaches, and how much more of it there must be
// than outside.
constexpr double kInside = 3.0;
constexpr double kMuchMore = 3.0;

}  // namespace

std::vector<bool> find_overhangs(const std::vector<SurfaceSample>& samples,
                                 const std::vector<bool>& is_roof,
                                 const std::vector<WallTrace>& walls, double reach) {
  std::vector<bool> overhangs(samples.size(), false);
  std::vector<size_t> near;
  for (const WallTrace& wall : walls) {
    if (wall.high - wall.low < reach) continue;
    near.clear();
    std::array<double, 2> beyond = {0.0, 0.0};  // behind the line, and in front of it
    for (size_t i = 0; i < samples.size(); ++i) {
      const SurfaceSample& sample = samples[i];
      if (sample.shape < 0 || !is_roof[sample.shape]) continue;
      if (sample.point.z() < wall.high - reach) continue;
      const Eigen::Vector2d p = sample.point.head<2>();
      const double distance = wall.line.signed_distance(p), along = wall.line.along(p);
      if (along < wall.line.begin || along > wall.line.end) continue;
      if (std::abs(distance) <= reach) {
        near.push_back(i);
      } else if (std::abs(distance) <= kInside * reach) {
        beyond[distance > 0.0] += sample.weight;
      }
    }
    for (const int front : {0, 1}) {
      if (!(beyond[1 - front] > kMuchMore * beyond[front])) continue;
      for (const size_t i : near) {
        const double distance = wall.line.signed_distance(samples[i].point.head<2>());
        if ((distance > 0.0) == (front == 1)) overhangs[i] = true;
      }
    }
  }
  return overhangs;
}

}  // namespace gable
