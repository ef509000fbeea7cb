#pragma once

#include <gable/engine/closing/closing_options.h>
#include <gable/engine/closing/height_sample.h>
#include <gable/grammar/solid/plane.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace gable {

/// Samples sorted into square cells of the plan, about one in each where there are not too many.
struct SampleGrid {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< least x and y, local frame
  double cell = 0.5;                                 ///< metres
  int rows = 0, cols = 0;                            ///< rows go along y
  std::vector<std::vector<int>> samples;             ///< rows x cols: numbers of samples

  size_t index(int row, int col) const { return static_cast<size_t>(row) * cols + col; }
  Eigen::Vector2d center(int row, int col) const {
    return corner + cell * Eigen::Vector2d(col + 0.5, row + 0.5);
  }
};

/// Sorts samples into at most about `max_cells` cells. No samples: a grid without cells.
SampleGrid make_sample_grid(const std::vector<HeightSample>& samples, int max_cells);

/// What a sample costs a plane: soft L1 of the height it misses, over the loss's scale, times the
/// sample's weight, cubic metres.
double sample_cost(const HeightSample& sample, const Plane& plane, double loss_scale);

/// The plane of every cell (-1: no samples), by a graph cut between neighbouring cells with the
/// costs of `options`. `reaches`: per plane where it may be used, or none: everywhere; cells that
/// no plane reaches may have any. `start`: labels to start from, or empty.
std::vector<int> label_grid(const SampleGrid& grid, const std::vector<HeightSample>& samples,
                            const std::vector<Plane>& planes,
                            const std::vector<Eigen::AlignedBox3d>& reaches,
                            const ClosingOptions& options, const std::vector<int>& start);

}  // namespace gable
