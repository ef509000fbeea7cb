#include <ceres/jet.h>
#include <gable/grammar/block.h>
#include <gable/residuals/outline_to_footprint.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gable {
namespace {

// Derivatives with respect to the azimuth and one footprint rule.
constexpr int kAzimuth = kMaxRuleParameters;
using Jet = ceres::Jet<double, kMaxRuleParameters + 1>;

template <typename T>
T component_distance(const Block<T>& b, const T& x, const T& y) {
  using namespace block_value;
  return rectangle_distance<T>(b[kX0], b[kX1], b[kY0], b[kY1], x, y);
}

}  // namespace

OutlineToFootprint::OutlineToFootprint(const House& house,
                                       const std::vector<Eigen::Vector2d>& outline,
                                       const OutlineOptions& options)
    : house_(house), loss_(LossKind::kSoftL1, options.loss_scale) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& from = outline[i];
    const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - from;
    const int pieces = static_cast<int>(std::ceil(edge.norm() / options.spacing));
    const double root_weight = std::sqrt(options.weight * edge.norm() / std::max(pieces, 1));
    for (int k = 0; k < pieces; ++k) {
      samples_.push_back({from + edge * ((k + 0.5) / pieces), root_weight});
    }
  }
  mutable_parameter_block_sizes()->push_back(house_.azimuth.size());
  for (const Rule& rule : house_.footprints) {
    mutable_parameter_block_sizes()->push_back(rule.size());
  }
  set_num_residuals(static_cast<int>(samples_.size()));
}

bool OutlineToFootprint::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const int num_components = house_.num_components();
  std::vector<Block<double>> blocks(num_components);
  std::vector<Block<Jet>> jets(jacobians == nullptr ? 0 : num_components);
  for (int c = 0; c < num_components; ++c) {
    const int footprint = house_.footprint_of_component(c);
    const RuleKind kind = house_.footprints[footprint].kind;
    const double* values = parameters[1 + footprint];
    internal::set_component_rectangle(kind, values, c, &blocks[c]);
    if (jacobians == nullptr) continue;
    std::array<Jet, kMaxRuleParameters> own;
    for (int k = 0; k < house_.footprints[footprint].size(); ++k) own[k] = Jet(values[k], k);
    internal::set_component_rectangle(kind, own.data(), c, &jets[c]);
  }
  const auto& sizes = parameter_block_sizes();
  if (jacobians != nullptr) {
    for (size_t b = 0; b < sizes.size(); ++b) {
      if (jacobians[b] != nullptr) std::fill_n(jacobians[b], samples_.size() * sizes[b], 0.0);
    }
  }
  const double cosine = std::cos(parameters[0][0]), sine = std::sin(parameters[0][0]);
  for (size_t i = 0; i < samples_.size(); ++i) {
    const Sample& sample = samples_[i];
    const double x = cosine * sample.local.x() + sine * sample.local.y();
    const double y = cosine * sample.local.y() - sine * sample.local.x();
    int nearest = 0;
    double distance = component_distance(blocks[0], x, y);
    for (int c = 1; c < num_components; ++c) {
      const double d = component_distance(blocks[c], x, y);
      if (d < distance) distance = d, nearest = c;
    }
    double robust, slope;
    loss_.evaluate(distance, &robust, &slope);
    residuals[i] = sample.root_weight * robust;
    if (jacobians == nullptr) continue;
    // Turning the house by a small angle a moves the point in the house frame by a (y, -x).
    Jet jet_x(x), jet_y(y);
    jet_x.v[kAzimuth] = y;
    jet_y.v[kAzimuth] = -x;
    const Jet jet = component_distance(jets[nearest], jet_x, jet_y);
    const double scale = sample.root_weight * slope;
    if (jacobians[0] != nullptr) jacobians[0][i] = scale * jet.v[kAzimuth];
    const int block = 1 + house_.footprint_of_component(nearest);
    if (jacobians[block] != nullptr) {
      for (int k = 0; k < sizes[block]; ++k) {
        jacobians[block][i * sizes[block] + k] = scale * jet.v[k];
      }
    }
  }
  return true;
}

}  // namespace gable
