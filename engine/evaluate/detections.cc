#include <gable/engine/evaluate/detections.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <tuple>

namespace gable {
namespace {

std::vector<Eigen::Vector2d> centers(const std::vector<Building>& buildings,
                                     std::vector<Rule> House::*rules) {
  std::vector<Eigen::Vector2d> points;
  for (const Building& building : buildings) {
    if (!building.house) continue;
    const House& house = *building.house;
    const HeightField field(house);
    // The first two parameters of dormers and chimneys are their centre in the house frame.
    for (const Rule& rule : house.*rules) {
      points.push_back(house.origin.head<2>() + field.local_from_house({rule[0], rule[1]}));
    }
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> dormer_centers(const std::vector<Building>& buildings) {
  return centers(buildings, &House::dormers);
}

std::vector<Eigen::Vector2d> chimney_centers(const std::vector<Building>& buildings) {
  return centers(buildings, &House::chimneys);
}

DetectionScore score_detections(const std::vector<Eigen::Vector2d>& found,
                                const std::vector<Eigen::Vector2d>& truth, double radius) {
  // Sorted by x, only a strip around each truth has to be looked at.
  std::vector<size_t> order(found.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return found[a].x() < found[b].x(); });
  std::vector<std::tuple<double, size_t, size_t>> pairs;  // (distance, truth, found)
  for (size_t t = 0; t < truth.size(); ++t) {
    auto it = std::lower_bound(order.begin(), order.end(), truth[t].x() - radius,
                               [&](size_t i, double x) { return found[i].x() < x; });
    for (; it != order.end() && found[*it].x() <= truth[t].x() + radius; ++it) {
      const double distance = (found[*it] - truth[t]).norm();
      if (distance <= radius) pairs.emplace_back(distance, t, *it);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> truth_taken(truth.size(), false), found_taken(found.size(), false);
  DetectionScore score;
  score.truth = static_cast<int>(truth.size());
  score.found = static_cast<int>(found.size());
  for (const auto& [distance, t, f] : pairs) {
    if (truth_taken[t] || found_taken[f]) continue;
    truth_taken[t] = found_taken[f] = true;
    ++score.correct;
  }
  return score;
}

}  // namespace gable
