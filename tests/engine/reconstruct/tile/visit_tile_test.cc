#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/io/scratch.h"

namespace gable {
namespace {

/// Slabs of 5 m on flat ground, 0.5 m cells, visited in windows of 200 cells and 20 m more.
class VisitTile : public testing::Test {
 protected:
  VisitTile() : dsm_({{400000.0, 200000.0}, 0.5, 100, 700}, 0.0f) {}

  void add_slab(const CellBox& box, float height = 5.0f) {
    for (int row = box.row0; row < box.row1; ++row) {
      for (int col = box.col0; col < box.col1; ++col) dsm_.at(row, col) = height;
    }
  }

  struct Visited {
    std::vector<std::string> ids;
    std::vector<long> cells;
    std::vector<char> of_row;
    std::vector<size_t> of_window;  ///< buildings
  };

  Visited visit(const std::vector<int>& skipped = {}, int window_cells = 200,
                bool cut_rows = true) const {
    const Crs crs = crs_from_text("EPSG:27700");
    write_raster(folder_.path("dsm.tif"), dsm_, crs);
    write_raster(folder_.path("dtm.tif"), HeightRaster(dsm_.grid, 0.0f), crs);
    const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
    TileOptions options;
    options.window_cells = window_cells;
    options.overlap = 20.0;
    options.cut_rows = cut_rows;
    Visited visited;
    TileCallbacks callbacks;
    callbacks.wants_window = [&](const TileWindow& window) {
      return std::find(skipped.begin(), skipped.end(), window.index) == skipped.end();
    };
    callbacks.deliver = [&](TileBuilding&& made) {
      visited.ids.push_back(made.building.id);
      visited.of_row.push_back(made.of_row);
      visited.cells.push_back(std::count_if(made.image.inside.begin(), made.image.inside.end(),
                                            [](auto inside) { return inside != 0; }));
    };
    callbacks.end_window = [&](const TileWindow&, const TileSummary& summary) {
      visited.of_window.push_back(summary.num_buildings);
    };
    visit_tile({&dsm, &dtm, nullptr, nullptr}, options, {}, callbacks,
               [](const std::string& id, const PlanPolygon*, TileBuilding* building) {
                 building->building.id = id;
               });
    return visited;
  }

  const ScratchFolder folder_;
  HeightRaster dsm_;
};

TEST_F(VisitTile, ARowThatIsLongerThanWindowsSeeIsCutWhereTheyMeet) {
  add_slab({40, 50, 60, 650});
  const Visited visited = visit();
  EXPECT_EQ(visited.cells, (std::vector<long>{125 * 20, 175 * 20, 175 * 20, 125 * 20}));
  EXPECT_EQ(visited.of_window, (std::vector<size_t>{1, 1, 1, 1}));
  EXPECT_EQ(visit({}, 2048).cells, (std::vector<long>{600 * 20}));
}

TEST_F(VisitTile, WindowsThatAreLeftOutChangeNothingInTheOthers) {
  for (const int col : {20, 160, 185, 340, 420, 520, 640}) add_slab({40, col, 60, col + 20});
  const Visited all = visit();
  EXPECT_EQ(all.ids.size(), 7u);
  std::vector<std::string> ids;
  for (const std::vector<int>& skipped :
       {std::vector<int>{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}) {
    const Visited one = visit(skipped);
    EXPECT_EQ(one.of_window.size(), 1u);
    ids.insert(ids.end(), one.ids.begin(), one.ids.end());
  }
  EXPECT_EQ(ids, all.ids);
}

TEST_F(VisitTile, ARowIsCutIntoItsHousesUnlessLeftWhole) {
  add_slab({40, 20, 64, 40}, 5.0f);
  add_slab({40, 40, 64, 60}, 7.0f);
  add_slab({40, 60, 64, 80}, 5.0f);
  add_slab({20, 100, 40, 130}, 5.0f);
  const Visited cut = visit();
  EXPECT_EQ(cut.cells, (std::vector<long>{600, 480, 480, 480}));
  EXPECT_EQ(cut.of_row, (std::vector<char>{0, 1, 1, 1}));
  EXPECT_EQ(cut.ids, (std::vector<std::string>{"b4000575_1999850", "b4000150_1999740",
                                               "b4000250_1999740", "b4000350_1999740"}));
  const Visited whole = visit({}, 200, false);
  EXPECT_EQ(whole.cells, (std::vector<long>{600, 1440}));
  EXPECT_EQ(whole.of_row, (std::vector<char>{0, 0}));
}

TEST_F(VisitTile, PiecesOfARowDoNotDependOnTheWindowsThatSeeAllOfIt) {
  for (int k = 0; k < 5; ++k) add_slab({40, 150 + 20 * k, 60, 170 + 20 * k}, k % 2 ? 7.0f : 5.0f);
  const Visited one = visit({}, 2048), many = visit({}, 210);
  EXPECT_GT(one.ids.size(), 2u);
  EXPECT_EQ(many.ids, one.ids);
  EXPECT_EQ(many.cells, one.cells);
}

TEST_F(VisitTile, HousesWithOneCentreHaveIdsOfTheirOwn) {
  add_slab({20, 20, 80, 80});
  add_slab({30, 30, 70, 70}, 0.0f);
  add_slab({40, 40, 60, 60});
  EXPECT_EQ(visit({}, 200, false).ids,
            (std::vector<std::string>{"b4000250_1999750", "b4000250_1999750-2"}));
}

TEST_F(VisitTile, IdsAreFineEnoughForSmallCells) {
  dsm_.grid.gsd = 0.2;
  add_slab({10, 20, 60, 70});
  EXPECT_EQ(visit().ids, (std::vector<std::string>{"b40000900_19999300"}));
}

}  // namespace
}  // namespace gable
