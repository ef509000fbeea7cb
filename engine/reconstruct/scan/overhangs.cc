#include <gable/engine/reconstruct/scan/overhangs.h>

#include <array>
#include <cmath>

namespace gable {
namespace {

// How far inside a wall its roof is looked for, in reaches, and how much more of it there must be
// than outside.
constexpr double kInside = 3.0;
constexpr double kMuchMore = 3.0;

// Walls between these distances, in reaches, stand in front of another one where they have this
// share of its samples; nearer ones are its own.
constexpr double kFrontBegins = 0.4;
constexpr double kFrontEnds = 1.5;
constexpr double kFrontShare = 0.2;

// How well the ends of a wall are known, in reaches.
constexpr double kEndSlack = 0.2;

/// What there is on either side of a wall: behind its line, and in front of it.
struct Sides {
  std::array<double, 2> roof = {0.0, 0.0};   // well inside or outside
  std::array<double, 2> walls = {0.0, 0.0};  // that stand there
  double wall = 0.0;                         // its own samples
};

}  // namespace

std::vector<bool> find_overhangs(const std::vector<SurfaceSample>& samples,
                                 const std::vector<bool>& is_roof,
                                 const std::vector<WallTrace>& walls, double reach) {
  // Beyond the ends of a wall a sample is an overhang if it is beyond those of two.
  std::vector<int> beside(samples.size(), 0), beyond_ends(samples.size(), 0);
  struct Near {
    size_t sample;
    bool front, beyond_end;
  };
  std::vector<Near> near;
  for (const WallTrace& wall : walls) {
    if (wall.high - wall.low < reach) continue;
    near.clear();
    Sides sides;
    for (size_t i = 0; i < samples.size(); ++i) {
      const SurfaceSample& sample = samples[i];
      const Eigen::Vector2d p = sample.point.head<2>();
      const double signed_distance = wall.line.signed_distance(p);
      const double distance = std::abs(signed_distance), along = wall.line.along(p);
      if (sample.shape < 0 || distance > kInside * reach) continue;
      const bool front = signed_distance > 0.0;
      const bool beyond_end =
          along < wall.line.begin - kEndSlack * reach || along > wall.line.end + kEndSlack * reach;
      if (is_roof[sample.shape]) {
        if (sample.point.z() < wall.high - reach) continue;
        if (distance <= reach && along > wall.line.begin - reach && along < wall.line.end + reach) {
          near.push_back({i, front, beyond_end});
        } else if (distance > reach && !beyond_end) {
          sides.roof[front] += sample.weight;
        }
      } else if (!beyond_end && sample.point.z() > wall.low && sample.point.z() < wall.high) {
        if (distance < kFrontBegins * reach) {
          sides.wall += sample.weight;
        } else if (distance < kFrontEnds * reach) {
          sides.walls[front] += sample.weight;
        }
      }
    }
    for (const int front : {0, 1}) {
      if (!(sides.roof[1 - front] > kMuchMore * sides.roof[front])) continue;
      if (sides.walls[front] > kFrontShare * sides.wall) continue;
      for (const Near& n : near) {
        if (n.front == (front == 1)) ++(n.beyond_end ? beyond_ends : beside)[n.sample];
      }
    }
  }
  std::vector<bool> overhangs(samples.size());
  for (size_t i = 0; i < samples.size(); ++i) {
    overhangs[i] = beside[i] > 0 || beyond_ends[i] > 1;
  }
  return overhangs;
}

}  // namespace gable
