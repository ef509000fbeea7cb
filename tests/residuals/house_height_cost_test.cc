#include <ceres/jet.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/robust_loss.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "residuals/random_houses.h"

namespace gable {
namespace {

// The cost as it is defined, one pixel after the other through the templated height field, with
// derivatives by automatic differentiation over all parameters at once.
constexpr int kMaxParameters = 72;
using WideJet = ceres::Jet<double, kMaxParameters>;

void plain_normal_equations(const House& house, const HeightImage& image,
                            const HeightCostOptions& options, NormalEquations* normal) {
  std::vector<std::vector<WideJet>> parameters;
  int n = 0;
  for (const Rule* rule : house.derivation()) {
    parameters.emplace_back();
    for (double v : rule->parameters()) parameters.back().push_back(WideJet(v, n++));
  }
  ASSERT_LE(n, kMaxParameters);
  std::vector<Block<WideJet>> blocks;
  for (const BlockSource& s : block_sources(house)) {
    blocks.push_back(expand_block<WideJet>(
        house, s, parameters[s.own_rule].data(),
        s.footprint_rule < 0 ? nullptr : parameters[s.footprint_rule].data()));
  }
  const RobustLoss loss(options.loss, options.loss_scale);
  const WideJet cosine = cos(parameters[0][0]), sine = sin(parameters[0][0]);
  normal->set_zero(n);
  for (int row = 0; row < image.rows; row += options.stride) {
    for (int col = 0; col < image.cols; col += options.stride) {
      const size_t i = image.index(row, col);
      if (image.weight[i] == 0.0f) continue;
      const Eigen::Vector2d p = image.center_of(row, col);
      const WideJet x = cosine * p.x() + sine * p.y();
      const WideJet y = cosine * p.y() - sine * p.x();
      const double z = image.height[i];
      const double support = std::max(options.support, image.spread);
      const auto seen = layers_at<WideJet, WideJet>(blocks, x, y, support);
      WideJet r;
      if (image.spread > 0.0) {
        r = loss.robust(height_at<WideJet, WideJet>(blocks, x, y, support, image.ground[i]) - z);
      } else if (seen.count > 0 && seen.layers[0].share.a == 1.0) {
        r = loss.robust(seen.layers[0].height - z);
      } else {
        WideJet cost = seen.ground_share * loss.cost(image.ground[i] - z);
        for (int k = 0; k < seen.count; ++k) {
          cost += seen.layers[k].share * loss.cost(seen.layers[k].height - z);
        }
        r = sqrt(cost);
      }
      const Eigen::VectorXd j = r.v.head(n);
      normal->jtj += j * j.transpose();
      normal->jtr += j * r.a;
      normal->squared_residuals += r.a * r.a;
    }
  }
}

TEST(HouseHeightCost, NormalEquationsEqualThePlainOnesPixelByPixel) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const House house = rich_house(kAllFoundations[seed % 6], &random);
    HeightImage image = noisy_image(seed);
    image.spread = random.chance(0.5) ? 1.2 : 0.0;
    const HeightCostOptions options{
        random.chance(0.5) ? 2.0 : 0.5,
        random.chance(0.5) ? LossKind::kSoftL1 : LossKind::kGemanMcClure, 0.3,
        random.integer(1, 2)};
    NormalEquations plain, fast;
    plain_normal_equations(house, image, options, &plain);
    const HouseHeightEvaluator evaluator(house, &image, options);
    evaluator.normal_equations(pointers(house).data(), &fast);
    EXPECT_NEAR(fast.squared_residuals, plain.squared_residuals, 1e-10 * plain.squared_residuals);
    EXPECT_NEAR(evaluator.squared_residuals(pointers(house).data()), plain.squared_residuals,
                1e-10 * plain.squared_residuals);
    EXPECT_LE((fast.jtr - plain.jtr).norm(), 1e-10 * plain.jtr.norm()) << seed;
    EXPECT_LE((fast.jtj - plain.jtj).norm(), 1e-10 * plain.jtj.norm()) << seed;
  }
}

TEST(HouseHeightCost, CompressedCostGradientAndHessianEqualThePlainOnes) {
  for (uint64_t seed = 20; seed < 40; ++seed) {
    Random random(seed);
    const House house = rich_house(kAllFoundations[seed % 6], &random);
    const HeightImage image = noisy_image(seed);
    const HeightCostOptions options{0.5, LossKind::kSoftL1, 0.3, 1};
    NormalEquations plain;
    plain_normal_equations(house, image, options, &plain);
    const HouseHeightCost cost(house, &image, options);
    const int n = cost.evaluator().num_parameters();
    ASSERT_EQ(cost.num_residuals(), n + 1);
    Eigen::VectorXd residuals(n + 1);
    std::vector<std::vector<double>> storage;
    std::vector<double*> jacobians;
    for (int size : cost.parameter_block_sizes()) storage.emplace_back((n + 1) * size);
    for (auto& s : storage) jacobians.push_back(s.data());
    ASSERT_TRUE(cost.Evaluate(pointers(house).data(), residuals.data(), jacobians.data()));
    Eigen::MatrixXd jacobian(n + 1, n);
    int column = 0;
    for (size_t b = 0; b < storage.size(); ++b) {
      const int size = cost.parameter_block_sizes()[b];
      for (int row = 0; row <= n; ++row) {
        for (int k = 0; k < size; ++k) jacobian(row, column + k) = storage[b][row * size + k];
      }
      column += size;
    }
    EXPECT_NEAR(residuals.squaredNorm(), plain.squared_residuals, 1e-10 * plain.squared_residuals);
    EXPECT_LE((jacobian.transpose() * residuals - plain.jtr).norm(), 1e-10 * plain.jtr.norm());
    EXPECT_LE((jacobian.transpose() * jacobian - plain.jtj).norm(), 1e-10 * plain.jtj.norm());
    Eigen::VectorXd cost_only(n + 1);
    ASSERT_TRUE(cost.Evaluate(pointers(house).data(), cost_only.data(), nullptr));
    EXPECT_NEAR(cost_only.squaredNorm(), plain.squared_residuals, 1e-10 * plain.squared_residuals);
  }
}

TEST(HouseHeightCost, GroundOnlyImageCostsWhatItsPixelsCost) {
  const HeightImage image = noisy_image(7);
  House house = make_house(Foundation::kI);
  house.footprints[0][0] = 1000.0;  // far outside the image
  const HouseHeightEvaluator evaluator(house, &image, {0.5, LossKind::kSoftL1, 0.3, 1});
  const RobustLoss loss(LossKind::kSoftL1, 0.3);
  double expected = 0.0;
  for (size_t i = 0; i < image.size(); ++i) {
    if (image.weight[i] > 0.0f) {
      expected += loss.cost(static_cast<double>(image.ground[i]) - image.height[i]);
    }
  }
  EXPECT_NEAR(evaluator.squared_residuals(pointers(house).data()), expected, 1e-9 * expected);
}

}  // namespace
}  // namespace gable
