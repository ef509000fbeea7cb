// A rule of one's own, outside the library: a round tower under a cone, fitted by the shared core.
#include <ceres/autodiff_cost_function.h>
#include <gable/engine/solver/minimizer.h>
#include <gable/grammar/random.h>
#include <gable/grammar/rule.h>
#include <gable/residuals/robust_loss.h>

#include <cstdio>

using namespace gable;

/// The rule's table, like those of grammar/rule.cc.
enum { kCenterX, kCenterY, kRadius, kEaves, kRise };
constexpr ParameterSpec kTower[] = {{"center_x", "m", -100.0, 100.0, 0.0, "the crop's centre"},
                                    {"center_y", "m", -100.0, 100.0, 0.0, "the crop's centre"},
                                    {"radius", "m", 1.0, 20.0, 3.0, "common value"},
                                    {"eaves", "m", 0.5, 200.0, 6.0, "common value"},
                                    {"rise", "m", 0.0, 50.0, 3.0, "common value"}};

/// Its height field over level ground at 0, as a sample with a support of that width sees it: the
/// covered share gives the radius a derivative.
template <typename T>
T tower_height(const T* p, double x, double y, double support) {
  using std::sqrt;
  const T dx = p[kCenterX] - x, dy = p[kCenterY] - y;
  const T distance = sqrt(dx * dx + dy * dy + 1e-12);
  T share = (p[kRadius] - distance) / support + 0.5;
  if (share < 0.0) share = T(0.0);
  if (share > 1.0) share = T(1.0);
  return share * (p[kEaves] + p[kRise] * (1.0 - distance / p[kRadius]));
}

/// robust(height of the tower - height of one pixel), metres.
struct TowerPixel {
  double x, y, height, support;
  template <typename T>
  bool operator()(const T* tower, T* residual) const {
    const RobustLoss loss(LossKind::kSoftL1, 0.3);
    residual[0] = loss.robust(tower_height(tower, x, y, support) - height);
    return true;
  }
};

int main() {
  const double truth[] = {1.2, -0.7, 2.6, 8.0, 4.5};
  double tower[5];
  for (int k = 0; k < 5; ++k) tower[k] = kTower[k].initial;
  for (const double support : {2.0, 0.5}) {  // a wide support first: it sees edges from afar
    Random random(1);
    ceres::Problem problem;
    for (double x = -8.0; x < 8.0; x += 0.5) {
      for (double y = -8.0; y < 8.0; y += 0.5) {
        const double height = tower_height(truth, x, y, 0.5) + random.normal(0.1);
        problem.AddResidualBlock(new ceres::AutoDiffCostFunction<TowerPixel, 1, 5>(
                                     new TowerPixel{x, y, height, support}),
                                 nullptr, tower);
      }
    }
    for (int k = 0; k < 5; ++k) {
      problem.SetParameterLowerBound(tower, k, kTower[k].lower);
      problem.SetParameterUpperBound(tower, k, kTower[k].upper);
    }
    minimize(MinimizerOptions{}, &problem);
  }
  for (int k = 0; k < 5; ++k) {
    std::printf("%s %.2f, true %.2f\n", std::string(kTower[k].name).c_str(), tower[k], truth[k]);
  }
}
