#include <gable/engine/scales/scale_chain.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Earth mover's distance of two histograms on a line: the L1 distance of their cumulatives.
double earth_movers_distance(const float* a, const float* b, int bins) {
  double sum_a = 0.0, sum_b = 0.0, distance = 0.0;
  for (int i = 0; i < bins; ++i) {
    sum_a += a[i];
    sum_b += b[i];
    distance += std::abs(sum_a - sum_b);
  }
  return sum_a == 0.0 || sum_b == 0.0 ? 0.0 : distance;
}

}  // namespace

std::string check(const ScaleChainOptions& options) {
  if (!(options.gamma >= 0.0 && options.gamma <= 1000.0)) return "gamma must lie in [0, 1000]";
  return "";
}

double feature_distance(const ScaleFeatures& a, const ScaleFeatures& b) {
  double squares = 0.0;
  int begin = 0;
  for (const int bins : {kDistanceBins, kAlignmentBins, kAreaBins, kVerticalBins}) {
    const double distance = earth_movers_distance(&a[begin], &b[begin], bins);
    squares += distance * distance;
    begin += bins;
  }
  return std::sqrt(squares);
}

std::vector<int> cheapest_labels(std::span<const double> unary, std::span<const double> jump,
                                 int num_labels) {
  CHECK_GE(num_labels, 1);
  const size_t n = unary.size() / num_labels;
  CHECK_EQ(unary.size(), n * num_labels);
  CHECK_EQ(jump.size() + 1, std::max<size_t>(n, 1));
  if (n == 0) return {};
  std::vector<double> cost(unary.begin(), unary.begin() + num_labels);
  std::vector<char> rose(n * num_labels, 0);
  for (size_t i = 1; i < n; ++i) {
    // From the top, so that the costs of the configuration before are still there.
    for (int label = num_labels - 1; label >= 0; --label) {
      const double risen =
          label > 0 ? cost[label - 1] + jump[i - 1] : std::numeric_limits<double>::infinity();
      // Walking back, a tie that rises here rises as late as it can.
      if (risen <= cost[label]) {
        cost[label] = risen;
        rose[i * num_labels + label] = 1;
      }
      cost[label] += unary[i * num_labels + label];
    }
  }
  std::vector<int> labels(n);
  int label = static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  for (size_t i = n; i-- > 0;) {
    labels[i] = label;
    label -= rose[i * num_labels + label];
  }
  return labels;
}

ScaleLabels label_trajectory(const std::vector<ScaleFeatures>& features, const Forest& forest,
                             const ScaleChainOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<double> jump;
  for (size_t i = 1; i < features.size(); ++i) {
    jump.push_back(options.gamma * std::exp(-feature_distance(features[i - 1], features[i]) / 2));
  }
  const std::vector<int> labels =
      cheapest_labels(label_costs(forest, features), jump, forest.num_labels);
  ScaleLabels out;
  out.num_configurations = static_cast<int>(labels.size());
  for (int scale = 1; scale < forest.num_labels; ++scale) {
    const auto first = std::lower_bound(labels.begin(), labels.end(), scale);
    out.first.push_back(static_cast<int>(first - labels.begin()));
  }
  return out;
}

}  // namespace gable
