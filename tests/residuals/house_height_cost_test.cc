#include <ceres/jet.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/random.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/robust_loss.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

HeightImage noisy_image(uint64_t seed) {
  Random random(seed);
  HeightImage image;
  image.rows = 40;
  image.cols = 44;
  image.gsd = 0.5;
  image.first_center = {-11.0, 10.0};
  for (size_t i = 0; i < image.size(); ++i) {
    image.height.push_back(static_cast<float>(random.uniform(0.0, 8.0)));
    image.ground.push_back(static_cast<float>(random.uniform(-0.3, 0.3)));
    image.weight.push_back(random.chance(0.1) ? 0.0f : 1.0f);
  }
  return image;
}

// A house with every kind of rule of its foundation, at random values.
House rich_house(Foundation foundation, Random* random) {
  House house = make_house(foundation);
  house.azimuth[0] = random->uniform(-3.0, 3.0);
  for (Rule& f : house.footprints) {
    for (double& v : f.parameters()) v += random->uniform(-2.0, 2.0);
    if (f.kind != RuleKind::kFootprintI) f[0] -= 6.0, f[1] -= 6.0;
  }
  for (Rule& roof : house.roofs) {
    const Axis ridge = random->chance(0.5) ? Axis::kX : Axis::kY;
    roof = make_rule(
        static_cast<RuleKind>(static_cast<int>(RuleKind::kRoofFlat) + random->integer(0, 2)));
    roof.ridge = ridge;
    roof[0] = random->uniform(3.0, 5.0);
    roof[1] = random->uniform(1.0, 4.0);
    roof[2] = random->uniform(0.05, 0.45);
    roof[3] = random->uniform(0.05, 0.45);
  }
  for (int k = 0; k < 2; ++k) {
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = random->integer(0, house.num_components() - 1);
    dormer.values = {random->uniform(-4.0, 4.0), random->uniform(-3.0, 3.0),
                     random->uniform(1.5, 3.0),  random->uniform(1.5, 3.0),
                     random->uniform(5.0, 7.0),  random->uniform(0.3, 1.0)};
    house.dormers.push_back(dormer);
    Rule chimney = make_rule(RuleKind::kChimney);
    chimney.values = {random->uniform(-4.0, 4.0), random->uniform(-4.0, 4.0),
                      random->uniform(0.6, 1.5), random->uniform(7.0, 9.0)};
    house.chimneys.push_back(chimney);
  }
  Rule garage_i = make_rule(RuleKind::kGarageI);
  garage_i.values = {random->uniform(4.0, 7.0), 0.0, 6.0, 3.0, 2.7};
  house.garages.push_back(garage_i);
  Rule garage_l = make_rule(RuleKind::kGarageL);
  garage_l.values = {-8.0, random->uniform(2.0, 5.0), 5.0, 2.0, 4.5, 2.2, 2.5};
  house.garages.push_back(garage_l);
  return house;
}

constexpr Foundation kFoundations[] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                                       Foundation::kL, Foundation::kU};

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
      const auto seen = layers_at<WideJet, WideJet>(blocks, x, y, options.support);
      const double z = image.height[i];
      WideJet r;
      if (seen.count > 0 && seen.layers[0].share.a == 1.0) {
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

std::vector<const double*> pointers(const House& house) {
  std::vector<const double*> out;
  for (const Rule* rule : house.derivation()) out.push_back(rule->values.data());
  return out;
}

TEST(HouseHeightCost, NormalEquationsEqualThePlainOnesPixelByPixel) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const House house = rich_house(kFoundations[seed % 5], &random);
    const HeightImage image = noisy_image(seed);
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
    const House house = rich_house(kFoundations[seed % 5], &random);
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
