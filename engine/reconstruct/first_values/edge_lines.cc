#include <gable/engine/reconstruct/first_values/edge_lines.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

// A step below this is a roof slope or noise, above it counts no further.
constexpr double kSmallStep = 0.6;
constexpr double kLargeStep = 2.5;

double step_score(double step) {
  return std::clamp(std::abs(step) - kSmallStep, 0.0, kLargeStep - kSmallStep);
}

// Per boundary along one axis: how strongly heights step there, and how many cells are inside on
// the higher side.
std::vector<double> boundary_scores(const RectifiedView& view, bool along_columns) {
  const int n = along_columns ? view.cols : view.rows;
  const int m = along_columns ? view.rows : view.cols;
  const auto at = [&](int line, int cross) {
    return along_columns ? view.index(cross, line) : view.index(line, cross);
  };
  std::vector<double> scores(n + 1, 0.0);
  for (int b = 1; b < n; ++b) {
    for (int cross = 0; cross < m; ++cross) {
      const size_t low = at(b - 1, cross), high = at(b, cross);
      if (!view.inside[low] && !view.inside[high]) continue;
      if (view.weight[low] < 0.5f || view.weight[high] < 0.5f) {
        // The mask's own end against pixels that are left out: a party wall.
        if (view.inside[low] != view.inside[high]) scores[b] += 0.5 * kLargeStep;
        continue;
      }
      scores[b] += step_score(view.height[high] - view.height[low]);
    }
  }
  return scores;
}

// First and last boundary around the bulk of the inside cells: a few cells beyond are noise.
std::pair<int, int> extent(const RectifiedView& view, bool along_columns) {
  const int n = along_columns ? view.cols : view.rows;
  std::vector<int> counts(n, 0);
  int total = 0;
  for (int row = 0; row < view.rows; ++row) {
    for (int col = 0; col < view.cols; ++col) {
      if (!view.inside[view.index(row, col)]) continue;
      ++counts[along_columns ? col : row];
      ++total;
    }
  }
  const int trim = total / 100;
  int first = 0, last = n, sum = 0;
  while (first < n && sum + counts[first] <= trim) sum += counts[first++];
  sum = 0;
  while (last > first && sum + counts[last - 1] <= trim) sum += counts[--last];
  return {first, last};
}

std::vector<int> pick(const RectifiedView& view, bool along_columns,
                      const EdgeLineOptions& options) {
  const std::vector<double> scores = boundary_scores(view, along_columns);
  const auto [first, last] = extent(view, along_columns);
  const double apart = options.separation / view.cell;
  std::vector<int> order(scores.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return scores[a] > scores[b]; });
  // A line must be carried by at least 1.5 m of full steps.
  const double least = 1.5 / view.cell * (kLargeStep - kSmallStep) * 0.5;
  std::vector<int> lines;
  const auto free_at = [&](int b) {
    return std::all_of(lines.begin(), lines.end(),
                       [&](int line) { return std::abs(line - b) >= apart; });
  };
  for (int b : order) {
    if (static_cast<int>(lines.size()) >= options.max_lines - 2 || scores[b] < least) break;
    if (free_at(b)) lines.push_back(b);
  }
  for (int b : {first, last}) {
    if (free_at(b)) lines.push_back(b);
  }
  std::sort(lines.begin(), lines.end());
  // Halve the widest gap while it is too wide and there is room.
  while (static_cast<int>(lines.size()) < options.max_lines) {
    size_t widest = 0;
    int width = 0;
    for (size_t i = 0; i + 1 < lines.size(); ++i) {
      if (lines[i + 1] - lines[i] > width) {
        width = lines[i + 1] - lines[i];
        widest = i;
      }
    }
    if (width * view.cell <= options.widest_gap) break;
    lines.insert(lines.begin() + widest + 1, lines[widest] + width / 2);
  }
  return lines;
}

}  // namespace

EdgeLines find_edge_lines(const RectifiedView& view, const EdgeLineOptions& options) {
  return {pick(view, true, options), pick(view, false, options)};
}

}  // namespace gable
