#include <gable/engine/reconstruct/tile_windows.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

int cell_within(double cell, int cells) {
  return static_cast<int>(std::clamp(cell, 0.0, cells - 1.0));
}

}  // namespace

std::vector<CellBox> window_cores(const Grid& grid, int cells) {
  const int down = (grid.rows + cells - 1) / cells, across = (grid.cols + cells - 1) / cells;
  const auto part = [](int size, int parts, int k) {
    return static_cast<int>(static_cast<int64_t>(size) * k / parts);
  };
  std::vector<CellBox> cores;
  for (int i = 0; i < down; ++i) {
    for (int j = 0; j < across; ++j) {
      cores.push_back({part(grid.rows, down, i), part(grid.cols, across, j),
                       part(grid.rows, down, i + 1), part(grid.cols, across, j + 1)});
    }
  }
  return cores;
}

Grid sub_grid(const Grid& grid, const CellBox& box) {
  Grid sub = grid;
  sub.north_west += grid.gsd * Eigen::Vector2d(box.col0, -box.row0);
  sub.rows = box.row1 - box.row0;
  sub.cols = box.col1 - box.col0;
  return sub;
}

CellBox union_of(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.row0, b.row0), std::min(a.col0, b.col0), std::max(a.row1, b.row1),
          std::max(a.col1, b.col1)};
}

CellBox cells_around(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Grid& grid) {
  const Eigen::Vector2d first = grid.cell_of({low.x(), high.y()});
  const Eigen::Vector2d last = grid.cell_of({high.x(), low.y()});
  CellBox box;
  box.add(cell_within(std::floor(first.x() + 0.5), grid.rows),
          cell_within(std::floor(first.y() + 0.5), grid.cols));
  box.add(cell_within(std::floor(last.x() + 0.5), grid.rows),
          cell_within(std::floor(last.y() + 0.5), grid.cols));
  return box;
}

bool holds_center(const CellBox& core, const CellBox& box) {
  const int row = (box.row0 + box.row1) / 2, col = (box.col0 + box.col1) / 2;
  return row >= core.row0 && row < core.row1 && col >= core.col0 && col < core.col1;
}

}  // namespace gable
