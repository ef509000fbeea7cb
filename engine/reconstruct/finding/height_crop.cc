#include <gable/engine/reconstruct/finding/height_crop.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// Whether a neighbour's cell lies among the eight around a cell.
bool beside_neighbour(const std::vector<CellRole>& roles, int rows, int cols, int row, int col) {
  for (int r = std::max(0, row - 1); r < std::min(rows, row + 2); ++r) {
    for (int c = std::max(0, col - 1); c < std::min(cols, col + 2); ++c) {
      if (roles[static_cast<size_t>(r) * cols + c] == CellRole::kNeighbour) return true;
    }
  }
  return false;
}

double median_terrain(const HeightRaster& dtm, const CellBox& box,
                      const std::vector<CellRole>& roles) {
  std::vector<float> inside, all;
  size_t i = 0;
  for (int row = box.row0; row < box.row1; ++row) {
    for (int col = box.col0; col < box.col1; ++col, ++i) {
      const float ground = dtm.at(row, col);
      if (!std::isfinite(ground)) continue;
      all.push_back(ground);
      if (roles[i] == CellRole::kBuilding) inside.push_back(ground);
    }
  }
  std::vector<float>& heights = inside.empty() ? all : inside;
  if (heights.empty()) return 0.0;
  std::nth_element(heights.begin(), heights.begin() + heights.size() / 2, heights.end());
  return heights[heights.size() / 2];
}

}  // namespace

std::string check(const HeightCropOptions& options) {
  if (!(options.margin >= 0.0 && options.margin <= 100.0)) return "margin must lie in [0, 100] m";
  if (options.max_cells < 100 || options.max_cells > 100000000) {
    return "max_cells must lie in [100, 1e8]";
  }
  if (!(options.neighbour >= 0.0 && options.neighbour < 0.1)) {
    return "neighbour must lie in [0, 0.1)";
  }
  if (!(options.row >= 0.0 && options.row <= 1.0)) return "row must lie in [0, 1]";
  if (!(options.outside >= 0.1 && options.outside <= 1.0)) return "outside must lie in [0.1, 1]";
  if (options.spread && !(*options.spread >= 0.0 && *options.spread <= 100.0)) {
    return "spread must lie in [0, 100] m";
  }
  return "";
}

CellBox with_margin(const CellBox& box, double margin, const Grid& grid) {
  const int cells = static_cast<int>(std::ceil(margin / grid.gsd));
  return {std::max(0, box.row0 - cells), std::max(0, box.col0 - cells),
          std::min(grid.rows, box.row1 + cells), std::min(grid.cols, box.col1 + cells)};
}

HeightImage crop_heights(const HeightRaster& dsm, const HeightRaster& dtm, const CellBox& box,
                         const std::vector<CellRole>& roles, bool outline_known,
                         const HeightCropOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK(dsm.grid == dtm.grid);
  const int rows = box.row1 - box.row0, cols = box.col1 - box.col0;
  CHECK(!box.empty() && roles.size() == static_cast<size_t>(rows) * cols);
  int factor = 1;
  while (static_cast<double>(rows) * cols >
         static_cast<double>(options.max_cells) * factor * factor)
    ++factor;

  HeightImage image;
  const Grid& grid = dsm.grid;
  const Eigen::Vector2d first = grid.center_of(box.row0, box.col0);
  const Eigen::Vector2d last = grid.center_of(box.row1 - 1, box.col1 - 1);
  image.origin << 0.5 * (first + last), median_terrain(dtm, box, roles);
  image.first_center = first - image.origin.head<2>();
  image.gsd = grid.gsd * factor;
  image.spread = options.spread.value_or(0.0);
  image.rows = (rows + factor - 1) / factor;
  image.cols = (cols + factor - 1) / factor;
  for (int row = 0; row < rows; row += factor) {
    for (int col = 0; col < cols; col += factor) {
      const CellRole role = roles[static_cast<size_t>(row) * cols + col];
      const double z = dsm.at(box.row0 + row, box.col0 + col) - image.origin.z();
      const double terrain = dtm.at(box.row0 + row, box.col0 + col) - image.origin.z();
      const float ground = std::isfinite(terrain) ? static_cast<float>(terrain) : 0.0f;
      float height = std::isfinite(z) ? static_cast<float>(z) : ground;
      float weight = std::isfinite(z) && std::isfinite(terrain) ? 1.0f : 0.0f;
      const bool own = role == CellRole::kBuilding || role == CellRole::kCovered;
      // What is known of no surface becomes ground of little weight: blocks do not spread over it
      // without need.
      const bool aside = role == CellRole::kCrown || role == CellRole::kCovered ||
                         (!outline_known && !own && role != CellRole::kRow &&
                          beside_neighbour(roles, rows, cols, row, col));
      if (aside) {
        height = ground;
        weight = std::min(weight, static_cast<float>(options.neighbour));
      } else if (role == CellRole::kRow) {
        height = ground;
        weight = std::min(weight, static_cast<float>(options.row));
      } else if (outline_known && !own) {
        height = ground;
        weight =
            static_cast<float>(role == CellRole::kNeighbour ? options.neighbour : options.outside);
      }
      image.height.push_back(height);
      image.ground.push_back(ground);
      image.weight.push_back(weight);
      image.inside.push_back(own);
    }
  }
  return image;
}

void move_origin(const Eigen::Vector3d& origin, HeightImage* image) {
  const Eigen::Vector3d step = image->origin - origin;
  image->first_center += step.head<2>();
  for (float& z : image->height) z = static_cast<float>(z + step.z());
  for (float& z : image->ground) z = static_cast<float>(z + step.z());
  image->origin = origin;
}

}  // namespace gable
