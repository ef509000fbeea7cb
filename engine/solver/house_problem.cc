#include <gable/engine/solver/house_problem.h>
#include <gable/engine/solver/minimizer.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Nothing stands far above the highest measurement, metres.
constexpr double kHeadroom = 2.0;

// Highest measurement of an image, metres above its origin.
double highest(const HeightImage& image) {
  double top = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < image.size(); ++i) {
    if (is_evidence(image, i)) top = std::max(top, static_cast<double>(image.height[i]));
  }
  return top;
}

bool is_height(const ParameterSpec& spec) { return spec.name == "eaves" || spec.name == "height"; }

void set_bounds(const Rule& rule, double top, double* block, ceres::Problem* problem) {
  std::vector<ParameterSpec> specs(parameter_specs(rule.kind).begin(),
                                   parameter_specs(rule.kind).end());
  for (size_t k = 0; k < specs.size(); ++k) {
    if (is_height(specs[k])) {
      specs[k].upper = std::clamp(top + kHeadroom, specs[k].lower + 1.0, specs[k].upper);
    }
    block[k] = std::clamp(block[k], specs[k].lower, specs[k].upper);
    if (std::isfinite(specs[k].lower)) {
      problem->SetParameterLowerBound(block, static_cast<int>(k), specs[k].lower);
    }
    if (std::isfinite(specs[k].upper)) {
      problem->SetParameterUpperBound(block, static_cast<int>(k), specs[k].upper);
    }
  }
}

}  // namespace

std::vector<double*> parameter_blocks(House* house) {
  std::vector<double*> blocks;
  for (Rule* rule : house->derivation()) blocks.push_back(rule->values.data());
  return blocks;
}

void set_house_bounds(const HeightImage& image, House* house, ceres::Problem* problem) {
  const double top = highest(image);
  for (Rule* rule : house->derivation()) set_bounds(*rule, top, rule->values.data(), problem);
}

HouseErrors house_errors(const HeightImage& image, const House& house) {
  const HeightField field(house);
  std::vector<double> errors;
  double sum = 0.0, squares = 0.0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      if (field.block_at_house(p) < 0) continue;
      const double error =
          std::abs(field.at_house(p, image.spread, image.ground[i]) - image.height[i]);
      errors.push_back(error);
      sum += error;
      squares += error * error;
    }
  }
  HouseErrors out;
  if (errors.empty()) return out;
  const double n = static_cast<double>(errors.size());
  out.mad = sum / n;
  out.rmse = std::sqrt(squares / n);
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  out.noise = shared_error(image) * 1.4826 * errors[errors.size() / 2];
  return out;
}

std::vector<std::vector<double>> house_deviations(double noise, House* house,
                                                  ceres::Problem* problem) {
  const std::vector<double> all =
      parameter_deviations(parameter_blocks(house), noise * noise, problem);
  std::vector<std::vector<double>> deviations;
  size_t next = 0;
  for (const Rule* rule : house->derivation()) {
    const size_t size = rule->parameters().size();
    deviations.emplace_back(all.begin() + next, all.begin() + next + size);
    next += size;
  }
  return deviations;
}

}  // namespace gable
