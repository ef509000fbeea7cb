#include <gable/grammar/synthesis/ground/vegetation.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// Calls visit(row, col) for the cells whose centres lie within `radius` of a box of the world.
template <typename Visit>
void for_cells_near(const Grid& grid, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                    double radius, Visit visit) {
  const Eigen::Vector2d first = grid.cell_of({low.x() - radius, high.y() + radius});
  const Eigen::Vector2d last = grid.cell_of({high.x() + radius, low.y() - radius});
  const int row_end = std::min(grid.rows - 1, static_cast<int>(std::floor(last.x())));
  const int col_end = std::min(grid.cols - 1, static_cast<int>(std::floor(last.y())));
  for (int row = std::max(0, static_cast<int>(std::ceil(first.x()))); row <= row_end; ++row) {
    for (int col = std::max(0, static_cast<int>(std::ceil(first.y()))); col <= col_end; ++col) {
      visit(row, col);
    }
  }
}

void raise(float to, float* height) { *height = std::max(*height, to); }

}  // namespace

Tree random_tree(const Eigen::Vector2d& center, Random* random) {
  Tree tree;
  tree.center = center;
  tree.radius = random->uniform(1.5, 4.0);
  tree.height = std::clamp(tree.radius * random->uniform(1.6, 3.2), 3.0, 10.0);
  return tree;
}

void add_tree(const Tree& tree, const HeightRaster& ground, Random* random, HeightRaster* surface) {
  Random leaves = random->fork();
  const double lobe = leaves.uniform(0.0, 2.0 * M_PI);
  const int lobes = leaves.integer(2, 5);
  const double crown_base = tree.height * leaves.uniform(0.2, 0.5);
  const double reach = 1.15 * tree.radius;
  for_cells_near(surface->grid, tree.center, tree.center, reach, [&](int row, int col) {
    const Eigen::Vector2d d = surface->grid.center_of(row, col) - tree.center;
    const double angle = std::atan2(d.y(), d.x());
    const double edge = tree.radius * (1.0 + 0.12 * std::sin(lobes * angle + lobe));
    const double depth = std::abs(leaves.normal(0.5));
    const bool gap = leaves.chance(0.125);
    const double share = d.norm() / edge;
    if (share >= 1.0 || gap) return;
    const double crown = std::sqrt(1.0 - share * share);
    const double height = crown_base + (tree.height - crown_base) * crown - depth;
    raise(static_cast<float>(ground.at(row, col) + std::max(0.0, height)), &surface->at(row, col));
  });
}

void add_hedge(const Hedge& hedge, const HeightRaster& ground, Random* random,
               HeightRaster* surface) {
  Random leaves = random->fork();
  const Eigen::Vector2d along = hedge.to - hedge.from;
  const double length_squared = std::max(along.squaredNorm(), 1e-12);
  for_cells_near(
      surface->grid, hedge.from.cwiseMin(hedge.to), hedge.from.cwiseMax(hedge.to), hedge.width,
      [&](int row, int col) {
        const Eigen::Vector2d p = surface->grid.center_of(row, col);
        const double roughness = leaves.normal(0.15);
        const double t = std::clamp((p - hedge.from).dot(along) / length_squared, 0.0, 1.0);
        if ((p - hedge.from - t * along).norm() > 0.5 * hedge.width) return;
        raise(static_cast<float>(ground.at(row, col) + std::max(0.2, hedge.height + roughness)),
              &surface->at(row, col));
      });
}

}  // namespace gable
