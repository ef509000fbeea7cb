#include <gable/engine/reconstruct/finding/found_rows.h>
#include <gable/residuals/height_image.h>

namespace gable {
namespace {

HeightImage image_of(const HeightRaster& dsm, const HeightRaster& dtm, const FoundHouses& found,
                     size_t index) {
  const CellBox& box = found.houses[index].box;
  const int label = static_cast<int>(index) + 1;
  HeightImage image;
  image.gsd = dsm.grid.gsd;
  image.rows = box.row1 - box.row0;
  image.cols = box.col1 - box.col0;
  for (int row = box.row0; row < box.row1; ++row) {
    for (int col = box.col0; col < box.col1; ++col) {
      const bool own = found.label.at(row, col) == label;
      image.height.push_back(dsm.at(row, col));
      image.ground.push_back(dtm.at(row, col));
      image.weight.push_back(own ? 1.0f : 0.0f);
      image.inside.push_back(own);
    }
  }
  return image;
}

}  // namespace

std::vector<size_t> cut_found_row(const HeightRaster& dsm, const HeightRaster& dtm, size_t index,
                                  const RowCutOptions& options, FoundHouses* found) {
  std::vector<size_t> places = {index};
  const FoundHouse whole = found->houses[index];
  if (whole.num_cells * dsm.grid.gsd * dsm.grid.gsd <= options.least_row) return places;
  RowPieces pieces = cut_rows(image_of(dsm, dtm, *found, index), options);
  if (pieces.cuts.size() < 2) return places;
  const int row_number = ++found->num_rows;
  found->houses[index] = {};
  for (size_t k = 1; k < pieces.cuts.size(); ++k) {
    places.push_back(found->houses.size());
    found->houses.emplace_back();
  }
  const Eigen::Vector2d first = dsm.grid.center_of(whole.box.row0, whole.box.col0);
  for (size_t k = 0; k < places.size(); ++k) {
    FoundHouse& house = found->houses[places[k]];
    house.row = row_number;
    house.cuts = std::move(pieces.cuts[k]);
    for (PlanLine& cut : house.cuts) cut.offset += cut.normal.dot(first);
  }
  size_t i = 0;
  for (int row = whole.box.row0; row < whole.box.row1; ++row) {
    for (int col = whole.box.col0; col < whole.box.col1; ++col, ++i) {
      if (pieces.piece[i] < 0) continue;
      const size_t place = places[pieces.piece[i]];
      found->label.at(row, col) = static_cast<int>(place) + 1;
      found->houses[place].box.add(row, col);
      ++found->houses[place].num_cells;
    }
  }
  return places;
}

}  // namespace gable
