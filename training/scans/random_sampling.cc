#include <gable/training/scans/random_sampling.h>

#include <array>
#include <cmath>

namespace gable {
namespace {

constexpr std::array kNoise = {0.0, 0.002, 0.005, 0.01};
constexpr std::array kOutliers = {0.0, 0.02, 0.05};

template <size_t N>
double one_of(const std::array<double, N>& values, Random* random) {
  return values[random->integer(0, static_cast<int>(N) - 1)];
}

}  // namespace

SampleOptions random_sampling(Random* random) {
  SampleOptions options;
  options.noise = one_of(kNoise, random);
  options.outlier_share = one_of(kOutliers, random);
  options.num_points = static_cast<int>(std::lround(
      std::exp(random->uniform(std::log(kLeastTrainingPoints), std::log(kMostTrainingPoints)))));
  options.seed = random->next();
  return options;
}

}  // namespace gable
