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
  const std::vector<int> pieces = cut_rows(image_of(dsm, dtm, *found, index), options);
  const int row_number = ++found->num_rows;
  found->houses[index] = {};
  found->houses[index].row = row_number;
  size_t i = 0;
  for (int row = whole.box.row0; row < whole.box.row1; ++row) {
    for (int col = whole.box.col0; col < whole.box.col1; ++col, ++i) {
      if (pieces[i] < 0) continue;
      if (static_cast<size_t>(pieces[i]) == places.size()) {
        places.push_back(found->houses.size());
        found->houses.emplace_back();
        found->houses.back().row = row_number;
      }
      const size_t place = places[pieces[i]];
      found->label.at(row, col) = static_cast<int>(place) + 1;
      found->houses[place].box.add(row, col);
      ++found->houses[place].num_cells;
    }
  }
  return places;
}

}  // namespace gable
