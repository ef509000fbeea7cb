#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/residuals/height_image.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace gable {
namespace {

// Narrower parts of houses are rare, the rims of crowns are narrower, metres.
constexpr double kLeastWidth = 2.0;

std::vector<unsigned char> crowns_of(const HeightRaster& dsm, const HeightRaster& dtm,
                                     const VegetationOptions& options) {
  HeightImage image;
  image.gsd = dsm.grid.gsd;
  image.rows = dsm.grid.rows;
  image.cols = dsm.grid.cols;
  image.height = dsm.values;
  image.ground = dtm.values;
  return find_vegetation(image, vegetation_at(options, image.gsd));
}

/// Labels the cells with high[i] != 0 that connect over edges to the cell `seed` with `label`.
FoundHouse flood(const std::vector<unsigned char>& high, size_t seed, int label,
                 Raster<int>* labels, std::vector<size_t>* cells) {
  FoundHouse house;
  const Grid& grid = labels->grid;
  cells->assign(1, seed);
  labels->values[seed] = label;
  for (size_t next = 0; next < cells->size(); ++next) {
    const int row = static_cast<int>((*cells)[next] / grid.cols);
    const int col = static_cast<int>((*cells)[next] % grid.cols);
    house.box.add(row, col);
    constexpr int kSteps[4][2] = {{-1, 0}, {0, -1}, {0, 1}, {1, 0}};
    for (const auto& step : kSteps) {
      const int r = row + step[0], c = col + step[1];
      if (!grid.contains(r, c)) continue;
      const size_t i = static_cast<size_t>(r) * grid.cols + c;
      if (!high[i] || labels->values[i] != 0) continue;
      labels->values[i] = label;
      cells->push_back(i);
    }
  }
  house.num_cells = static_cast<int>(cells->size());
  return house;
}

/// How much of a tree a piece looks like: the number of crown cells within `reach` cells of it, and
/// of its own cells where it is narrower than `width` cells.
int crown_and_rim(const Raster<int>& labels, const Raster<unsigned char>& crown, int label,
                  const FoundHouse& house, int reach, int width) {
  const Grid& grid = labels.grid;
  const CellBox& box = house.box;
  const int row0 = std::max(0, box.row0 - reach), row1 = std::min(grid.rows, box.row1 + reach);
  const int col0 = std::max(0, box.col0 - reach), col1 = std::min(grid.cols, box.col1 + reach);
  cv::Mat piece(row1 - row0, col1 - col0, CV_8U), around, wide;
  for (int row = row0; row < row1; ++row) {
    for (int col = col0; col < col1; ++col) {
      piece.at<unsigned char>(row - row0, col - col0) = labels.at(row, col) == label;
    }
  }
  cv::dilate(piece, around, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));
  cv::morphologyEx(piece, wide, cv::MORPH_OPEN, cv::Mat::ones(width, width, CV_8U));
  int count = house.num_cells - cv::countNonZero(wide);
  for (int row = row0; row < row1; ++row) {
    for (int col = col0; col < col1; ++col) {
      count += around.at<unsigned char>(row - row0, col - col0) && crown.at(row, col);
    }
  }
  return count;
}

/// The high cells beside the crowns that hang together, those that are no houses dropped.
FoundHouses pieces_beside(const HeightRaster& dsm, const HeightRaster& dtm,
                          const Raster<unsigned char>& crown, const FindHousesOptions& options) {
  const Grid& grid = dsm.grid;
  FoundHouses found;
  found.label = Raster<int>(grid, 0);
  std::vector<unsigned char> high(grid.size(), 0);
  for (size_t i = 0; i < high.size(); ++i) {
    high[i] = !crown.values[i] && dsm.values[i] - dtm.values[i] > options.least_height;
  }

  const double cell_area = grid.gsd * grid.gsd;
  const int reach = static_cast<int>(std::lround(options.crown_reach / grid.gsd));
  const int width = std::max(2, static_cast<int>(std::lround(kLeastWidth / grid.gsd)));
  std::vector<size_t> cells;
  for (size_t seed = 0; seed < high.size(); ++seed) {
    if (!high[seed] || found.label.values[seed] != 0) continue;
    const int label = static_cast<int>(found.houses.size()) + 1;
    const FoundHouse house = flood(high, seed, label, &found.label, &cells);
    const bool small = house.num_cells * cell_area < options.least_area;
    const bool tree =
        !small && crown_and_rim(found.label, crown, label, house, reach, width) > house.num_cells;
    if (!small && !tree) {
      found.houses.push_back(house);
      continue;
    }
    (small ? found.num_small : found.num_crown) += 1;
    for (const size_t i : cells) found.label.values[i] = FoundHouses::kDropped;
  }
  return found;
}

/// Takes the crowns away whose rims are houses' for the most part. Returns whether there are any.
bool drop_crowns_on_roofs(const FindHousesOptions& options, const FoundHouses& found,
                          Raster<unsigned char>* crown) {
  const Grid& grid = crown->grid;
  const cv::Mat mask(grid.rows, grid.cols, CV_8U, crown->values.data());
  cv::Mat labels;
  const int count = cv::connectedComponents(mask, labels, 8, CV_32S);
  std::vector<int> rim(count, 0), roof(count, 0);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      if (labels.at<int>(row, col) != 0) continue;
      // A cell may lie on the rims of several crowns.
      std::array<int, 4> beside{};
      int num_beside = 0;
      constexpr int kSteps[4][2] = {{-1, 0}, {0, -1}, {0, 1}, {1, 0}};
      for (const auto& step : kSteps) {
        const int r = row + step[0], c = col + step[1];
        if (!grid.contains(r, c)) continue;
        const int label = labels.at<int>(r, c);
        const auto end = beside.begin() + num_beside;
        if (label == 0 || std::find(beside.begin(), end, label) != end) continue;
        beside[num_beside++] = label;
        ++rim[label];
        roof[label] += found.label.at(row, col) > 0;
      }
    }
  }
  bool any = false;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const int label = labels.at<int>(row, col);
      if (label == 0 || roof[label] <= options.roof_rim * rim[label]) continue;
      crown->at(row, col) = 0;
      any = true;
    }
  }
  return any;
}

/// Takes the crowns away that lie within `reach` cells of a house. Returns whether there are any.
bool drop_crowns_on_facades(const FoundHouses& found, int reach, Raster<unsigned char>* crown) {
  const Grid& grid = crown->grid;
  cv::Mat house(grid.rows, grid.cols, CV_8U);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      house.at<unsigned char>(row, col) = found.label.at(row, col) > 0;
    }
  }
  cv::dilate(house, house, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}), {-1, -1}, reach);
  bool any = false;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      if (!crown->at(row, col) || !house.at<unsigned char>(row, col)) continue;
      crown->at(row, col) = 0;
      any = true;
    }
  }
  return any;
}

/// Removes the houses that are not kept and numbers the others anew, in the same order.
void keep_houses(const std::vector<char>& keep, FoundHouses* found) {
  std::vector<int> new_label(found->houses.size() + 1, FoundHouses::kDropped);
  new_label[0] = 0;
  std::vector<FoundHouse> kept;
  for (size_t i = 0; i < found->houses.size(); ++i) {
    if (!keep[i]) continue;
    kept.push_back(found->houses[i]);
    new_label[i + 1] = static_cast<int>(kept.size());
  }
  for (int& label : found->label.values) label = label < 0 ? label : new_label[label];
  found->houses = std::move(kept);
}

}  // namespace

std::string check(const FindHousesOptions& options) {
  if (!(options.least_height > 0.0 && options.least_height <= 100.0)) {
    return "least_height must lie in (0, 100] m";
  }
  if (!(options.least_area >= 0.0 && options.least_area <= 1e6)) {
    return "least_area must lie in [0, 1e6] square metres";
  }
  if (!(options.crown_reach >= 0.0 && options.crown_reach <= 10.0)) {
    return "crown_reach must lie in [0, 10] m";
  }
  if (!(options.roof_rim >= 0.0 && options.roof_rim <= 1.0)) return "roof_rim must lie in [0, 1]";
  if (!(options.facade >= 0.0 && options.facade <= 10.0)) return "facade must lie in [0, 10] m";
  return "";
}

void CellBox::add(int row, int col) {
  if (empty()) {
    *this = {row, col, row + 1, col + 1};
    return;
  }
  row0 = std::min(row0, row);
  col0 = std::min(col0, col);
  row1 = std::max(row1, row + 1);
  col1 = std::max(col1, col + 1);
}

FoundHouses find_houses(const HeightRaster& dsm, const HeightRaster& dtm,
                        const FindHousesOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK(dsm.grid == dtm.grid);
  Raster<unsigned char> crown(dsm.grid, 0);
  crown.values = crowns_of(dsm, dtm, options.vegetation);
  FoundHouses found = pieces_beside(dsm, dtm, crown, options);
  if (drop_crowns_on_roofs(options, found, &crown)) {
    found = pieces_beside(dsm, dtm, crown, options);
  }
  const int reach = static_cast<int>(std::lround(options.facade / dsm.grid.gsd));
  if (reach > 0 && drop_crowns_on_facades(found, reach, &crown)) {
    found = pieces_beside(dsm, dtm, crown, options);
  }
  found.crown = std::move(crown);
  return found;
}

int keep_near_footprints(const std::vector<PlanPolygon>& polygons, FoundHouses* found) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanPolygon& polygon : polygons) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : polygon.outer) box.extend(p);
    if (box.isEmpty()) continue;
    const Eigen::Vector2d half = box.sizes();
    boxes.emplace_back(box.center() - half, box.center() + half);
  }
  const Grid& grid = found->label.grid;
  std::vector<char> keep;
  for (const FoundHouse& house : found->houses) {
    const Eigen::Vector2d a = grid.center_of(house.box.row0, house.box.col0);
    const Eigen::Vector2d b = grid.center_of(house.box.row1 - 1, house.box.col1 - 1);
    keep.push_back(std::any_of(boxes.begin(), boxes.end(), [&](const Eigen::AlignedBox2d& box) {
      return box.contains(a) && box.contains(b);
    }));
  }
  const int dropped = static_cast<int>(std::count(keep.begin(), keep.end(), 0));
  keep_houses(keep, found);
  return dropped;
}

}  // namespace gable
