#include <gable/engine/reconstruct/first_values/roof_fit.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/residuals/robust_loss.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>

#include "engine/house_image.h"

namespace gable {
namespace {

constexpr CellRectangle kRectangle{4, 28, 3, 17};  // 12 m by 7 m

// A view of one block that fills kRectangle, over ground at 0.
RectifiedView view_of(const Rule& roof) {
  RectifiedView view;
  view.rows = 22;
  view.cols = 32;
  view.cell = 0.5;
  const House house = [&] {
    House h = make_house(Foundation::kI);
    h.footprints = {rectangle_rule(2.0, 14.0, 1.5, 8.5)};
    h.roofs = {roof};
    return h;
  }();
  const HeightField field(house);
  for (int row = 0; row < view.rows; ++row) {
    for (int col = 0; col < view.cols; ++col) {
      const Eigen::Vector2d p(view.x_edge(col) + 0.25, view.y_edge(row) + 0.25);
      view.height.push_back(static_cast<float>(field.at_house(p, 0.0, 0.0)));
      view.inside.push_back(view.height.back() > 0.0f);
    }
  }
  view.ground.assign(view.height.size(), 0.0f);
  view.weight.assign(view.height.size(), 1.0f);
  return view;
}

// Hips of equal pitch have a run of half the width.
std::vector<Rule> roofs_of_equal_pitch() {
  std::vector<Rule> roofs = {flat_roof(4.5)};
  for (const Axis ridge : {Axis::kX, Axis::kY}) {
    const double hip = ridge == Axis::kX ? 3.5 / 12.0 : 0.5;
    roofs.push_back(gable_roof(4.5, 2.2, ridge));
    roofs.push_back(hip_roof(4.5, 2.2, hip, 0.0, ridge));
    roofs.push_back(hip_roof(4.5, 2.2, 0.0, hip, ridge));
    roofs.push_back(hip_roof(4.5, 2.2, hip, hip, ridge));
  }
  return roofs;
}

TEST(RoofFit, RecoversFlatGabledAndHippedRoofsExactly) {
  for (const Rule& roof : roofs_of_equal_pitch()) {
    const RectifiedView view = view_of(roof);
    const RoofFit fit = fit_roof(view, kRectangle, roof.ridge, 0.3, 0.3);
    const bool flat = roof.kind == RuleKind::kRoofFlat;
    EXPECT_EQ(fit.flat, flat) << rule_name(roof.kind);
    EXPECT_EQ(fit.ridge, roof.ridge);
    EXPECT_EQ(fit.rectangle, kRectangle);
    EXPECT_NEAR(fit.eaves, 4.5, 1e-5);
    EXPECT_NEAR(fit.rise, flat ? 0.0 : 2.2, 1e-5);
    EXPECT_NEAR(fit.hip_start, roof[param::roof::kHipStart], 1e-12);
    EXPECT_NEAR(fit.hip_end, roof[param::roof::kHipEnd], 1e-12);
    EXPECT_NEAR(fit.cost, 0.0, 1e-6);
  }
}

TEST(RoofFit, AcrossTheRidgeFitsWorse) {
  const RectifiedView view = view_of(gable_roof(4.5, 2.2, Axis::kX));
  EXPECT_GT(fit_roof(view, kRectangle, Axis::kX, 0.3, 0.3).gain,
            fit_roof(view, kRectangle, Axis::kY, 0.3, 0.3).gain + 1.0);
}

TEST(RoofFit, StaysCloseWithAFifthOfOutliers) {
  Random random(5);
  for (const Rule& roof : roofs_of_equal_pitch()) {
    RectifiedView view = view_of(roof);
    for (float& z : view.height) {
      if (random.chance(0.2)) z = static_cast<float>(random.uniform(0.0, 12.0));
    }
    const RoofFit fit = fit_roof(view, kRectangle, roof.ridge, 0.3, 0.3);
    EXPECT_EQ(fit.flat, roof.kind == RuleKind::kRoofFlat);
    EXPECT_NEAR(fit.eaves, 4.5, 0.15) << rule_name(roof.kind);
    EXPECT_NEAR(fit.rise, fit.flat ? 0.0 : 2.2, 0.2) << rule_name(roof.kind);
    EXPECT_NEAR(fit.hip_start, roof[param::roof::kHipStart], 1e-12);
    EXPECT_NEAR(fit.hip_end, roof[param::roof::kHipEnd], 1e-12);
  }
}

TEST(RoofFit, IsOrdinaryLeastSquaresWhereNoResidualIsLarge) {
  RectifiedView view = view_of(gable_roof(4.5, 2.2, Axis::kX));
  Random random(8);
  for (float& z : view.height) z += static_cast<float>(random.normal(0.2));
  for (float& w : view.weight) w = static_cast<float>(random.uniform(0.2, 1.0));
  const RoofFit fit = fit_roof(view, kRectangle, Axis::kX, 1e4, 0.3);
  const int n = kRectangle.rows() * kRectangle.cols();
  Eigen::MatrixXd a(n, 2);
  Eigen::VectorXd z(n);
  int k = 0;
  for (int row = kRectangle.row0; row < kRectangle.row1; ++row) {
    for (int col = kRectangle.col0; col < kRectangle.col1; ++col, ++k) {
      const double from_low = (row - kRectangle.row0 + 0.5) * view.cell;
      const double root = std::sqrt(view.weight[view.index(row, col)]);
      a(k, 0) = root;
      a(k, 1) = root * std::min(from_low, 7.0 - from_low) / 3.5;
      z[k] = root * view.height[view.index(row, col)];
    }
  }
  const Eigen::Vector2d expected = a.colPivHouseholderQr().solve(z);
  EXPECT_FALSE(fit.flat);
  EXPECT_EQ(fit.hip_start + fit.hip_end, 0.0);
  EXPECT_NEAR(fit.eaves, expected[0], 1e-6);
  EXPECT_NEAR(fit.rise, expected[1], 1e-6);
}

TEST(RoofFit, GainIsWhatTheRoofSavesAgainstTheGround) {
  RectifiedView view = view_of(gable_roof(4.5, 2.2, Axis::kX));
  Random random(9);
  for (float& z : view.height) z += static_cast<float>(random.normal(0.2));
  for (float& g : view.ground) g = static_cast<float>(random.uniform(-0.5, 0.5));
  const RoofFit fit = fit_roof(view, kRectangle, Axis::kX, 0.3, 0.3);
  const RobustLoss loss(LossKind::kSoftL1, 0.3);
  double ground = 0.0, roof = 0.0;
  int k = 0;
  for (int row = kRectangle.row0; row < kRectangle.row1; ++row) {
    for (int col = kRectangle.col0; col < kRectangle.col1; ++col, ++k) {
      const size_t i = view.index(row, col);
      ground += loss.cost(static_cast<double>(view.ground[i]) - view.height[i]);
      roof += loss.cost(static_cast<double>(fit.heights[k]) - view.height[i]);
    }
  }
  EXPECT_NEAR(fit.cost, roof, 1e-3);
  EXPECT_NEAR(fit.gain, ground - roof, 1e-3);
  EXPECT_NEAR(std::accumulate(fit.gains.begin(), fit.gains.end(), 0.0), fit.gain, 1e-2);
}

TEST(RoofFit, WhereHeightsAreMeansTheRoofIsThatOfTheMiddle) {
  const Rule roof = hip_roof(4.5, 2.2, 3.5 / 12.0, 3.5 / 12.0, Axis::kX);
  RectifiedView view = view_of(roof);
  const RectifiedView sharp = view;
  constexpr int kReach = 2;  // cells
  view.spread = (2 * kReach + 1) * view.cell;
  for (int row = kReach; row < view.rows - kReach; ++row) {
    for (int col = kReach; col < view.cols - kReach; ++col) {
      float sum = 0.0f;
      for (int r = row - kReach; r <= row + kReach; ++r) {
        for (int c = col - kReach; c <= col + kReach; ++c) sum += sharp.height[sharp.index(r, c)];
      }
      view.height[view.index(row, col)] = sum / ((2 * kReach + 1) * (2 * kReach + 1));
    }
  }
  const RoofFit fit = fit_roof(view, kRectangle, Axis::kX, 0.3, 0.3);
  EXPECT_NEAR(fit.eaves, 4.5, 0.3);
  EXPECT_NEAR(fit.eaves + fit.rise, 6.7, 0.4);
  // Taken for single surfaces, the ramps drag the eaves down.
  view.spread = 0.0;
  EXPECT_LT(fit_roof(view, kRectangle, Axis::kX, 0.3, 0.3).eaves, fit.eaves - 0.3);
}

}  // namespace
}  // namespace gable
