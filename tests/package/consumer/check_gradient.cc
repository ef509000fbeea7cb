#include <gable/residuals/point_to_plane.h>
#include <gable/residuals/testing/gradient_check.h>

#include <cstdio>
#include <memory>

// Checks the derivatives of a residual: what users do with residuals of their own.
int main() {
  const std::unique_ptr<ceres::CostFunction> cost(
      gable::PointToPlane::create({1.0, 2.0, 3.0}, 0.5));
  const auto result = gable::check_gradient(*cost, {{0.6, 0.0, 0.8, 1.5}});
  std::printf("%s\n", result.evaluated && result.relative_error < 1e-6 ? "exact" : "wrong");
}
