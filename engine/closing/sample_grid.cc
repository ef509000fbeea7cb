#include <gable/engine/closing/label_expansion.h>
#include <gable/engine/closing/sample_grid.h>
#include <gable/residuals/robust_loss.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// More than the samples of a cell can cost.
constexpr double kOutOfReach = 1e7;

bool in_reach(const Eigen::AlignedBox3d& reach, const Eigen::Vector2d& p) {
  return (p.array() >= reach.min().head<2>().array()).all() &&
         (p.array() <= reach.max().head<2>().array()).all();
}

}  // namespace

SampleGrid make_sample_grid(const std::vector<HeightSample>& samples, int max_cells) {
  SampleGrid grid;
  if (samples.empty()) return grid;
  Eigen::Vector2d low = samples.front().point.head<2>(), high = low;
  double area = 0.0;
  for (const HeightSample& sample : samples) {
    low = low.cwiseMin(sample.point.head<2>());
    high = high.cwiseMax(sample.point.head<2>());
    area += sample.weight;
  }
  const Eigen::Vector2d extent = high - low;
  // As large as what a sample speaks for: a raster gets one of its pixels in every cell.
  grid.cell = std::sqrt(area / static_cast<double>(samples.size()));
  const auto cells = [&] {
    return (extent.x() / grid.cell + 1.0) * (extent.y() / grid.cell + 1.0);
  };
  // Samples sharing a cell are summed, so the cells alone say how much work there is; the factor
  // allows for the parts of the box that hold no samples.
  while (cells() > 2.0 * max_cells) grid.cell *= 1.1;
  grid.cols = static_cast<int>(extent.x() / grid.cell + 0.5) + 1;
  grid.rows = static_cast<int>(extent.y() / grid.cell + 0.5) + 1;
  grid.corner = low - 0.5 * grid.cell * Eigen::Vector2d::Ones();
  grid.samples.resize(static_cast<size_t>(grid.rows) * grid.cols);
  for (size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d at = (samples[i].point.head<2>() - grid.corner) / grid.cell;
    const int col = std::clamp(static_cast<int>(at.x()), 0, grid.cols - 1);
    const int row = std::clamp(static_cast<int>(at.y()), 0, grid.rows - 1);
    grid.samples[grid.index(row, col)].push_back(static_cast<int>(i));
  }
  return grid;
}

double sample_cost(const HeightSample& sample, const Plane& plane, double loss_scale) {
  const RobustLoss loss(LossKind::kSoftL1, loss_scale);
  return sample.weight * loss.cost(sample.point.z() - plane.at(sample.point.head<2>())) /
         loss_scale;
}

std::vector<int> label_grid(const SampleGrid& grid, const std::vector<HeightSample>& samples,
                            const std::vector<Plane>& planes,
                            const std::vector<Eigen::AlignedBox3d>& reaches,
                            const ClosingOptions& options, const std::vector<int>& start) {
  CHECK(!planes.empty());
  CHECK(reaches.empty() || reaches.size() == planes.size());
  CHECK(start.empty() || start.size() == grid.samples.size());
  LabelProblem problem;
  problem.num_labels = static_cast<int>(planes.size());
  problem.impossible = kOutOfReach;
  problem.charges.assign(planes.size(), options.plane_charge);
  std::vector<int> site_of(grid.samples.size(), -1), labels;
  for (size_t c = 0; c < grid.samples.size(); ++c) {
    if (grid.samples[c].empty()) continue;
    site_of[c] = static_cast<int>(labels.size());
    int best = 0;
    const size_t first = problem.data.size();
    const Eigen::Vector2d middle =
        grid.center(static_cast<int>(c) / grid.cols, static_cast<int>(c) % grid.cols);
    for (size_t l = 0; l < planes.size(); ++l) {
      if (!reaches.empty() && !in_reach(reaches[l], middle)) {
        problem.data.push_back(problem.impossible);
        continue;
      }
      double cost = 0.0;
      for (const int s : grid.samples[c]) {
        cost += sample_cost(samples[s], planes[l], options.loss_scale);
      }
      problem.data.push_back(cost);
      if (cost < problem.data[first + best]) best = static_cast<int>(l);
    }
    labels.push_back(start.empty() || start[c] < 0 ? best : start[c]);
  }
  std::vector<Eigen::Vector2d> middles;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const int site = site_of[grid.index(row, col)];
      const int east = col + 1 < grid.cols ? site_of[grid.index(row, col + 1)] : -1;
      const int north = row + 1 < grid.rows ? site_of[grid.index(row + 1, col)] : -1;
      for (const int other : {east, north}) {
        if (site < 0 || other < 0) continue;
        problem.pairs.push_back({site, other});
        const Eigen::Vector2d aside =
            other == east ? Eigen::Vector2d(0.5, 0.0) : Eigen::Vector2d(0.0, 0.5);
        middles.push_back(grid.center(row, col) + grid.cell * aside);
      }
    }
  }
  problem.pair_cost = [&](int pair, int a, int b) {
    if (a == b) return 0.0;
    const double step = std::abs(planes[a].at(middles[pair]) - planes[b].at(middles[pair]));
    return grid.cell * (options.boundary_cost + options.step_cost * step);
  };
  expand_labels(problem, &labels);
  std::vector<int> of_cell(grid.samples.size(), -1);
  for (size_t c = 0; c < of_cell.size(); ++c) {
    if (site_of[c] >= 0) of_cell[c] = labels[site_of[c]];
  }
  return of_cell;
}

}  // namespace gable
