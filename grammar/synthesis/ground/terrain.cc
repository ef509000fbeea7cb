#include <gable/grammar/synthesis/ground/terrain.h>

#include <cmath>

namespace gable {
namespace {

Eigen::Vector2d random_direction(Random* random) {
  const double angle = random->uniform(0.0, 2.0 * M_PI);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Terrain::Terrain(const Eigen::Vector2d& center, double height, double steepness, Random* random)
    : center_(center), height_(height) {
  constexpr int kWaves = 4;
  tilt_ = steepness * random->uniform(0.2, 0.5) * random_direction(random);
  for (int i = 0; i < kWaves; ++i) {
    const double frequency = 2.0 * M_PI / random->uniform(180.0, 600.0);
    // The slopes of tilt and waves add up to `steepness` at most.
    const double slope = steepness * random->uniform(0.3, 1.0) * 0.5 / kWaves;
    waves_.push_back({frequency * random_direction(random), random->uniform(0.0, 2.0 * M_PI),
                      slope / frequency});
  }
}

double Terrain::at(const Eigen::Vector2d& world) const {
  const Eigen::Vector2d p = world - center_;
  double height = height_ + tilt_.dot(p);
  for (const Wave& wave : waves_) {
    height += wave.amplitude * std::cos(wave.frequency.dot(p) + wave.phase);
  }
  return height;
}

}  // namespace gable
