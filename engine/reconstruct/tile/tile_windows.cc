#include <gable/engine/reconstruct/tile/tile_windows.h>

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

std::vector<TileWindow> tile_windows(const HeightSource& dsm, int cells, bool everywhere) {
  const Grid& grid = dsm.grid();
  std::vector<CellBox> parts;
  for (const Grid& tile : dsm.tiles()) parts.push_back(cells_of_part(tile, grid));
  const int across = (grid.cols + cells - 1) / cells;
  std::vector<TileWindow> windows;
  int place = 0;
  for (const CellBox& core : window_cores(grid, cells)) {
    const bool held =
        everywhere || std::any_of(parts.begin(), parts.end(), [&](const CellBox& part) {
          return !intersection_of(part, core).empty();
        });
    const int index = static_cast<int>(windows.size());
    if (held) windows.push_back({index, place / across, place % across, core});
    ++place;
  }
  return windows;
}

CellBox cells_of_part(const Grid& part, const Grid& grid) {
  const Eigen::Vector2d first = grid.cell_of(part.center_of(0, 0));
  // Cells are counted as real numbers first: the part may lie anywhere.
  const double row = std::round(first.x()), col = std::round(first.y());
  const auto within = [](double cell, int cells) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(cells)));
  };
  return {within(row, grid.rows), within(col, grid.cols), within(row + part.rows, grid.rows),
          within(col + part.cols, grid.cols)};
}

CellBox intersection_of(const CellBox& a, const CellBox& b) {
  return {std::max(a.row0, b.row0), std::max(a.col0, b.col0), std::min(a.row1, b.row1),
          std::min(a.col1, b.col1)};
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
