#include <gable/engine/evaluate/detections.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <tuple>
#include <utility>

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

namespace {

/// Pairs of points within `radius` of each other, nearest first, each point once, as (index of a,
/// index of b).
std::vector<std::pair<size_t, size_t>> nearest_pairs(const std::vector<Eigen::Vector2d>& a,
                                                     const std::vector<Eigen::Vector2d>& b,
                                                     double radius) {
  // Sorted by x, only a strip around each point has to be looked at.
  std::vector<size_t> order(b.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return b[i].x() < b[j].x(); });
  std::vector<std::tuple<double, size_t, size_t>> near;  // (distance, a, b)
  for (size_t i = 0; i < a.size(); ++i) {
    auto it = std::lower_bound(order.begin(), order.end(), a[i].x() - radius,
                               [&](size_t j, double x) { return b[j].x() < x; });
    for (; it != order.end() && b[*it].x() <= a[i].x() + radius; ++it) {
      const double distance = (b[*it] - a[i]).norm();
      if (distance <= radius) near.emplace_back(distance, i, *it);
    }
  }
  std::sort(near.begin(), near.end());
  std::vector<bool> a_taken(a.size(), false), b_taken(b.size(), false);
  std::vector<std::pair<size_t, size_t>> pairs;
  for (const auto& [distance, i, j] : near) {
    if (a_taken[i] || b_taken[j]) continue;
    a_taken[i] = b_taken[j] = true;
    pairs.emplace_back(i, j);
  }
  return pairs;
}

}  // namespace

DetectionScore score_detections(const std::vector<Eigen::Vector2d>& found,
                                const std::vector<Eigen::Vector2d>& truth, double radius,
                                const std::vector<Eigen::Vector2d>& faint) {
  const auto correct = nearest_pairs(truth, found, radius);
  DetectionScore score;
  score.truth = static_cast<int>(truth.size());
  score.correct = static_cast<int>(correct.size());
  std::vector<bool> taken(found.size(), false);
  for (const auto& [t, f] : correct) taken[f] = true;
  std::vector<Eigen::Vector2d> left;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!taken[i]) left.push_back(found[i]);
  }
  score.found = static_cast<int>(found.size() - nearest_pairs(faint, left, radius).size());
  return score;
}

}  // namespace gable
