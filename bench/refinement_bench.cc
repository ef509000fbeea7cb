#include <benchmark/benchmark.h>
#include <ceres/numeric_diff_cost_function.h>
#include <ceres/solver.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/pixel_height_residual.h>
#include <gable/residuals/robust_loss.h>
#include <glog/logging.h>

#include <cmath>
#include <functional>
#include <vector>

#include "two_block_scene.h"

namespace gable {
namespace {

// The stages of all three.
const std::vector<RefinementStage>& stages() {
  static const std::vector<RefinementStage> kStages = {{2.0, LossKind::kSoftL1, 0.3, 1, 20},
                                                       {0.5, LossKind::kSoftL1, 0.3, 1, 20}};
  return kStages;
}

HeightCostOptions cost_options(const RefinementStage& stage) {
  return {stage.support, stage.loss, stage.loss_scale, stage.stride};
}

struct Outcome {
  double cost = 0.0;
  int iterations = 0;
};

std::vector<double*> blocks_of(House* house) {
  std::vector<double*> blocks;
  for (Rule* rule : house->derivation()) blocks.push_back(rule->values.data());
  return blocks;
}

void set_bounds(House* house, ceres::Problem* problem) {
  for (Rule* rule : house->derivation()) {
    const auto specs = parameter_specs(rule->kind);
    for (int k = 0; k < rule->size(); ++k) {
      if (std::isfinite(specs[k].lower)) {
        problem->SetParameterLowerBound(rule->values.data(), k, specs[k].lower);
      }
      if (std::isfinite(specs[k].upper)) {
        problem->SetParameterUpperBound(rule->values.data(), k, specs[k].upper);
      }
    }
  }
}

// Solves one stage the way a Ceres user would, with gable's stopping rule.
void solve(ceres::LinearSolverType solver, ceres::Problem* problem, Outcome* outcome) {
  const RefinementOptions defaults;
  ceres::Solver::Options options;
  options.linear_solver_type = solver;
  options.max_num_iterations = stages()[0].max_iterations;
  options.function_tolerance = defaults.function_tolerance;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, problem, &summary);
  outcome->cost = summary.final_cost;
  outcome->iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
}

Outcome refine_with_gable(const TwoBlockScene& scene) {
  House house = scene.start;
  RefinementOptions options;
  options.stages = stages();
  options.deviations = false;
  const RefinementSummary summary = refine_house(scene.image, options, &house);
  return {summary.final_cost, summary.iterations};
}

// One AutoDiff residual block per pixel.
Outcome refine_per_pixel(const TwoBlockScene& scene) {
  House house = scene.start;
  Outcome outcome;
  for (const RefinementStage& stage : stages()) {
    ceres::Problem problem;
    for (int row = 0; row < scene.image.rows; ++row) {
      for (int col = 0; col < scene.image.cols; ++col) {
        const size_t i = scene.image.index(row, col);
        problem.AddResidualBlock(PixelHeightResidual::create<4, 2>(
                                     house, scene.image.center_of(row, col), scene.image.height[i],
                                     scene.image.ground[i], cost_options(stage)),
                                 nullptr, blocks_of(&house));
      }
    }
    set_bounds(&house, &problem);
    solve(ceres::DENSE_NORMAL_CHOLESKY, &problem, &outcome);
  }
  return outcome;
}

// The robust residuals of the whole image as one function, for numeric differences.
class ImageResiduals {
 public:
  ImageResiduals(const House& house, const HeightImage& image, const HeightCostOptions& options)
      : house_(house), image_(&image), options_(options) {}

  bool operator()(const double* azimuth, const double* footprint_a, const double* footprint_b,
                  const double* roof_a, const double* roof_b, double* residuals) const {
    House house = house_;
    const double* values[] = {azimuth, footprint_a, footprint_b, roof_a, roof_b};
    int block = 0;
    for (Rule* rule : house.derivation()) {
      std::copy_n(values[block++], rule->size(), rule->values.data());
    }
    const HeightField field(house);
    const RobustLoss loss(options_.loss, options_.loss_scale);
    for (int row = 0; row < image_->rows; ++row) {
      for (int col = 0; col < image_->cols; ++col) {
        const size_t i = image_->index(row, col);
        const Eigen::Vector2d p = field.house_from_local(image_->center_of(row, col));
        const auto seen = layers_at<double, double>(field.blocks(), p.x(), p.y(), options_.support);
        double cost = seen.ground_share * loss.cost(double{image_->ground[i]} - image_->height[i]);
        for (int k = 0; k < seen.count; ++k) {
          cost += seen.layers[k].share * loss.cost(seen.layers[k].height - image_->height[i]);
        }
        residuals[i] = std::sqrt(cost);
      }
    }
    return true;
  }

 private:
  House house_;
  const HeightImage* image_;
  HeightCostOptions options_;
};

// Central differences of the whole image, as the paper's own implementation does.
Outcome refine_numeric(const TwoBlockScene& scene) {
  House house = scene.start;
  Outcome outcome;
  for (const RefinementStage& stage : stages()) {
    ceres::Problem problem;
    problem.AddResidualBlock(
        new ceres::NumericDiffCostFunction<ImageResiduals, ceres::CENTRAL, 64 * 64, 1, 4, 4, 4, 2>(
            new ImageResiduals(house, scene.image, cost_options(stage))),
        nullptr, blocks_of(&house));
    set_bounds(&house, &problem);
    solve(ceres::DENSE_NORMAL_CHOLESKY, &problem, &outcome);
  }
  return outcome;
}

void run(benchmark::State& state, const std::function<Outcome(const TwoBlockScene&)>& refine) {
  const TwoBlockScene scene = make_two_block_scene();
  const double reference = refine_with_gable(scene).cost;
  Outcome outcome;
  for (auto _ : state) outcome = refine(scene);
  CHECK_LE(std::abs(outcome.cost - reference), 1e-3 * reference)
      << "the benchmarks do not end at the same cost";
  state.counters["cost"] = outcome.cost;
  state.counters["iterations"] = outcome.iterations;
}

void BM_RefineTwoBlocks(benchmark::State& state) { run(state, refine_with_gable); }
BENCHMARK(BM_RefineTwoBlocks)->Unit(benchmark::kMillisecond);

void BM_RefinePerPixel(benchmark::State& state) { run(state, refine_per_pixel); }
BENCHMARK(BM_RefinePerPixel)->Unit(benchmark::kMillisecond);

void BM_RefineNumeric(benchmark::State& state) { run(state, refine_numeric); }
BENCHMARK(BM_RefineNumeric)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gable
