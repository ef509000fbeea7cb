#include <gable/engine/reconstruct/choice/mansard_roofs.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/height_field.h>

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

namespace gable {
namespace {

constexpr int kLeastSamples = 12;
constexpr int kReweightings = 4;

// What a mansard looks like: the rise per run of its lower part, also relative to its upper part.
constexpr double kLeastLowerSlope = 1.0;
constexpr double kLeastSlopeRatio = 2.0;

// Lower parts narrower than this, cells, are walls seen in the cells of the rim.
constexpr double kLeastLowerCells = 2.0;

// Parameters that a mansard has more than a gable.
constexpr int kMoreParameters = 2;

struct ProfileFit {
  Eigen::Vector3d heights;  // eaves, rise over the lower part, rise over the upper part
  double cost = 0.0;
};

// Height as a function of the distance s from the eaves: linear in the eaves and the rises of the
// parts below and above `break_run`. A break at 1 is none.
ProfileFit fit_profile(const std::vector<Eigen::Vector2d>& samples, double break_run,
                       const RobustLoss& loss) {
  const auto row = [&](double s) {
    const double upper = break_run < 1.0 ? std::max(0.0, s - break_run) / (1.0 - break_run) : 0.0;
    return Eigen::Vector3d(1.0, std::min(s, break_run) / break_run, upper);
  };
  ProfileFit fit;
  fit.heights.setZero();
  for (int round = 0; round <= kReweightings; ++round) {
    Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    fit.cost = 0.0;
    for (const Eigen::Vector2d& sample : samples) {
      const Eigen::Vector3d at = row(sample.x());
      const double error = at.dot(fit.heights) - sample.y();
      fit.cost += loss.cost(error);
      const double weight = round == 0 ? 1.0 : loss.slope(error);
      normal += weight * at * at.transpose();
      right += weight * sample.y() * at;
    }
    if (round < kReweightings) fit.heights = normal.ldlt().solve(right);
  }
  return fit;
}

// Heights over the sides of a component by their distance from the eaves. Means that reach over the
// eaves are not of the roof alone.
std::vector<Eigen::Vector2d> side_samples(const HeightImage& image, const HeightField& field,
                                          int component) {
  using namespace block_value;
  const Block<double>& block = field.blocks()[component];
  const bool along_x = block.ridge == Axis::kX;
  const double v0 = along_x ? block[kY0] : block[kX0], v1 = along_x ? block[kY1] : block[kX1];
  std::vector<Eigen::Vector2d> samples;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (!is_evidence(image, i)) continue;
      const Eigen::Vector2d p = field.house_from_local(image.center_of(row, col));
      if (field.block_at_house(p) != component) continue;
      const Facet facet = roof_facet<double, double>(block, p.x(), p.y());
      if (facet != Facet::kLow && facet != Facet::kHigh) continue;
      const double v = along_x ? p.y() : p.x();
      const double from_eaves = std::min(v - v0, v1 - v);
      if (from_eaves < 0.5 * image.spread) continue;
      samples.emplace_back(from_eaves / (0.5 * (v1 - v0)), image.height[i]);
    }
  }
  return samples;
}

// The mansard that a component's heights bend like, if they do.
std::optional<Rule> bent_roof(const HeightImage& image, const PenaltyOptions& penalty,
                              const HeightField& field, const Rule& roof, int component) {
  const RobustLoss loss(penalty.loss, penalty.loss_scale);
  const auto profile = fit_broken_profile(side_samples(image, field, component), loss);
  if (!profile) return std::nullopt;
  const double paid = kMoreParameters * parameter_price(image) * penalty.noise * penalty.noise;
  if (profile->saved <= paid) return std::nullopt;
  using namespace block_value;
  const Block<double>& block = field.blocks()[component];
  const double width = roof.ridge == Axis::kX ? block[kY1] - block[kY0] : block[kX1] - block[kX0];
  const double half_width = 0.5 * width;
  const double lower = profile->lower_rise / (profile->break_run * half_width);
  const double upper = profile->upper_rise / ((1.0 - profile->break_run) * half_width);
  if (profile->break_run * half_width < kLeastLowerCells * image.gsd) return std::nullopt;
  if (lower < kLeastLowerSlope || lower < kLeastSlopeRatio * upper) return std::nullopt;
  Rule mansard = make_rule(RuleKind::kRoofMansard);
  mansard.ridge = roof.ridge;
  const double rise = profile->lower_rise + std::max(profile->upper_rise, 0.0);
  const double values[] = {profile->eaves, rise, profile->lower_rise / rise, profile->break_run};
  const auto specs = parameter_specs(mansard.kind);
  for (size_t k = 0; k < specs.size(); ++k) {
    mansard[static_cast<int>(k)] = std::clamp(values[k], specs[k].lower, specs[k].upper);
  }
  return mansard;
}

}  // namespace

std::optional<BrokenProfile> fit_broken_profile(const std::vector<Eigen::Vector2d>& samples,
                                                const RobustLoss& loss) {
  if (samples.size() < kLeastSamples) return std::nullopt;
  const double unbroken = fit_profile(samples, 1.0, loss).cost;
  std::optional<BrokenProfile> best;
  for (int step = 2; step <= 10; ++step) {
    const double run = 0.05 * step;
    const ProfileFit fit = fit_profile(samples, run, loss);
    const double saved = unbroken - fit.cost;
    if (best && saved <= best->saved) continue;
    best = BrokenProfile{fit.heights[0], fit.heights[1], fit.heights[2], run, saved};
  }
  return best;
}

int make_mansards(const HeightImage& image, const PenaltyOptions& penalty, House* house) {
  int changed = 0;
  double cost = -1.0;
  for (int i = 0; i < house->num_components(); ++i) {
    const Rule& roof = house->roofs[i];
    if (roof.kind != RuleKind::kRoofGable && roof.kind != RuleKind::kRoofHip) continue;
    const auto mansard = bent_roof(image, penalty, HeightField(*house), roof, i);
    if (!mansard) continue;
    House bent = *house;
    bent.roofs[i] = *mansard;
    RefinementOptions options;
    options.stages = {{0.5, LossKind::kGemanMcClure, 0.5, 1, 12}};
    options.function_tolerance = 1e-3;
    options.deviations = false;
    refine_house(image, options, &bent);
    if (cost < 0.0) cost = penalised_cost(image, *house, penalty).total;
    const double with = penalised_cost(image, bent, penalty).total;
    if (with >= cost) continue;
    cost = with;
    *house = std::move(bent);
    ++changed;
  }
  return changed;
}

}  // namespace gable
