#include <gable/engine/scales/scale_chain.h>
#include <gable/engine/scales/train_scales.h>
#include <gable/grammar/random.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// Numbers of shapes are counted down to the last configuration, which has at least one.
double shapes_ratio(int a, int b, int num_configurations) {
  const double left_a = std::max(1, num_configurations - a);
  const double left_b = std::max(1, num_configurations - b);
  return std::max(left_a / left_b, left_b / left_a);
}

std::vector<char> draw_training_set(size_t count, double share, uint64_t seed) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  Random random(seed);
  for (size_t i = count; i > 1; --i) {
    std::swap(order[i - 1], order[random.integer(0, static_cast<int>(i) - 1)]);
  }
  const size_t taken =
      std::clamp<size_t>(std::lround(share * static_cast<double>(count)), 1, count);
  std::vector<char> trained_on(count, 0);
  for (size_t i = 0; i < taken; ++i) trained_on[order[i]] = 1;
  return trained_on;
}

}  // namespace

int64_t LabellingScore::configurations() const {
  int64_t sum = 0;
  for (const auto& row : confusion) sum = std::accumulate(row.begin(), row.end(), sum);
  return sum;
}

double LabellingScore::accuracy() const {
  int64_t right = 0;
  for (size_t label = 0; label < confusion.size(); ++label) right += confusion[label][label];
  const int64_t all = configurations();
  return all == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(all);
}

std::string check(const ScaleTrainingOptions& options) {
  if (!(options.training_share > 0.0 && options.training_share <= 1.0)) {
    return "training_share must lie in (0, 1]";
  }
  const std::string chain = check(ScaleChainOptions{options.gamma});
  return chain.empty() ? check(options.forest) : chain;
}

LabellingScore score_labelling(const std::vector<std::vector<ScaleFeatures>>& trajectories,
                               const std::vector<ScaleLabels>& known, const ScaleModel& model) {
  CHECK_EQ(trajectories.size(), known.size());
  const int scales = model.num_scales();
  LabellingScore score;
  score.trajectories = static_cast<int>(trajectories.size());
  score.confusion.assign(scales + 1, std::vector<int64_t>(scales + 1, 0));
  std::vector<std::vector<double>> distances(scales), ratios(scales);
  for (size_t t = 0; t < trajectories.size(); ++t) {
    CHECK_EQ(known[t].num_scales(), scales);
    const ScaleLabels found = label_trajectory(trajectories[t], model.forest, {model.gamma});
    const std::vector<int> expected = known[t].labels(), labels = found.labels();
    for (size_t i = 0; i < labels.size(); ++i) ++score.confusion[expected[i]][labels[i]];
    for (int k = 0; k < scales; ++k) {
      distances[k].push_back(std::abs(found.first[k] - known[t].first[k]));
      ratios[k].push_back(
          shapes_ratio(found.first[k], known[t].first[k], found.num_configurations));
    }
  }
  for (int k = 0; k < scales; ++k) {
    score.boundary_distance.push_back(median(distances[k]));
    score.boundary_ratio.push_back(median(ratios[k]));
  }
  return score;
}

ScaleTraining train_scales(const std::string& name,
                           const std::vector<std::vector<ScaleFeatures>>& trajectories,
                           const std::vector<ScaleLabels>& known,
                           const ScaleTrainingOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK_EQ(trajectories.size(), known.size());
  CHECK(!trajectories.empty());
  ScaleTraining out;
  out.trained_on = draw_training_set(trajectories.size(), options.training_share, options.seed);
  std::vector<LabelledTrajectory> samples;
  std::vector<std::vector<ScaleFeatures>> training, testing;
  std::vector<ScaleLabels> training_known, testing_known;
  for (size_t t = 0; t < trajectories.size(); ++t) {
    if (out.trained_on[t]) samples.push_back({trajectories[t], known[t].labels()});
    (out.trained_on[t] ? training : testing).push_back(trajectories[t]);
    (out.trained_on[t] ? training_known : testing_known).push_back(known[t]);
  }
  out.model.name = name;
  out.model.gamma = options.gamma;
  out.model.forest = train_forest(samples, known.front().num_scales(), options.forest);
  out.training = score_labelling(training, training_known, out.model);
  out.testing = score_labelling(testing, testing_known, out.model);
  return out;
}

}  // namespace gable
