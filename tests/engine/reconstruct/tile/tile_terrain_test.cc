#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_mosaic.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gable/engine/reconstruct/tile/tile_terrain.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>

#include <cmath>
#include <limits>

#include "engine/io/scratch.h"

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A slope with boxes of 10 m on it, 200 x 240 cells of 0.5 m.
HeightRaster surface() {
  HeightRaster raster({{1000.0, 2000.0}, 0.5, 200, 240}, 0.0f);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 240; ++col) {
      const bool box = row % 50 >= 20 && row % 50 < 40 && col % 60 >= 20 && col % 60 < 40;
      raster.at(row, col) = 0.02f * static_cast<float>(col) + (box ? 5.0f : 0.0f);
    }
  }
  return raster;
}

HeightRaster slope(const Grid& grid) {
  HeightRaster raster(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      raster.at(row, col) = 0.04f * static_cast<float>(grid.center_of(row, col).x() - 1000.25);
    }
  }
  return raster;
}

class TileTerrainTest : public testing::Test {
 protected:
  TileTerrainTest() {
    write_raster(folder_.path("dsm.tif"), surface(), crs_);
    options_.block_cells = 64;
    options_.margin = 20.0;
    options_.scratch = folder_.path("");
  }

  std::string write(const std::string& name, const HeightRaster& raster) const {
    write_raster(folder_.path(name), raster, crs_);
    return folder_.path(name);
  }

  static float most_off(const HeightRaster& terrain) {
    const HeightRaster truth = slope(terrain.grid);
    float most = 0.0f;
    for (size_t i = 0; i < truth.values.size(); ++i) {
      most = std::max(most, std::abs(truth.values[i] - terrain.values[i]));
    }
    return most;
  }

  const ScratchFolder folder_;
  const Crs crs_ = crs_from_text("EPSG:28992");
  TileTerrainOptions options_;
};

TEST_F(TileTerrainTest, ACellHasOneHeightWhicheverWindowAsks) {
  const RasterFile dsm(folder_.path("dsm.tif"));
  TileTerrain terrain(dsm, nullptr, options_);
  const HeightRaster all = terrain.read({0, 0, 200, 240});
  EXPECT_LT(most_off(all), 0.3f);
  TileTerrain other(dsm, nullptr, options_);  // asked in another order
  for (const CellBox& box : {CellBox{150, 200, 200, 240}, {0, 0, 90, 100}, {60, 50, 160, 239}}) {
    const HeightRaster part = other.read(box);
    for (int row = box.row0; row < box.row1; ++row) {
      for (int col = box.col0; col < box.col1; ++col) {
        ASSERT_EQ(part.at(row - box.row0, col - box.col0), all.at(row, col)) << row << " " << col;
      }
    }
  }
}

TEST_F(TileTerrainTest, OneBlockIsWhatIsDerivedAtOnce) {
  const RasterFile dsm(folder_.path("dsm.tif"));
  options_.block_cells = 2048;
  TileTerrain terrain(dsm, nullptr, options_);
  EXPECT_EQ(terrain.read({0, 0, 200, 240}).values, derive_terrain(dsm.read()).values);
}

TEST_F(TileTerrainTest, AGivenTerrainIsTakenAsItIsAndItsGapsFilled) {
  HeightRaster given = slope(surface().grid);
  for (int row = 60; row < 100; ++row) {
    for (int col = 60; col < 100; ++col) given.at(row, col) = kNan;
  }
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(write("dtm.tif", given));
  TileTerrain terrain(dsm, &dtm, options_);
  const HeightRaster all = terrain.read({0, 0, 200, 240});
  EXPECT_LT(most_off(all), 0.1f);
  for (int row = 0; row < 200; ++row) {
    for (int col = 0; col < 240; ++col) {
      if (std::isnan(given.at(row, col))) continue;
      EXPECT_EQ(all.at(row, col), given.at(row, col));
    }
  }
}

TEST_F(TileTerrainTest, WhereAGivenTerrainDoesNotReachItIsDerived) {
  HeightRaster west = slope({{1000.0, 2000.0}, 0.5, 200, 100});
  for (float& z : west.values) z += 0.5f;  // to tell it from what is derived
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(write("west.tif", west));
  TileTerrain terrain(dsm, &dtm, options_);
  TileTerrain derived(dsm, nullptr, options_);
  const HeightRaster all = terrain.read({0, 0, 200, 240});
  const HeightRaster without = derived.read({0, 0, 200, 240});
  for (int row = 0; row < 200; ++row) {
    EXPECT_EQ(all.at(row, 99), west.at(row, 99));
    EXPECT_EQ(all.at(row, 100), without.at(row, 100));
    EXPECT_EQ(all.at(row, 239), without.at(row, 239));
  }
}

TEST(TileWindows, AreThoseThatTilesReach) {
  const ScratchFolder folder;
  const Crs crs = crs_from_text("EPSG:28992");
  const HeightRaster tile({{1000.0, 2000.0}, 1.0, 100, 100}, 1.0f);
  HeightRaster far = tile;
  far.grid.north_west = {1200.0, 1800.0};
  write_raster(folder.path("a.tif"), tile, crs);
  write_raster(folder.path("b.tif"), far, crs);
  const RasterMosaic mosaic({folder.path("a.tif"), folder.path("b.tif")});
  EXPECT_EQ(tile_windows(mosaic, 100, true).size(), 9u);
  const std::vector<TileWindow> windows = tile_windows(mosaic, 100, false);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_EQ(windows[1].index, 1);
  EXPECT_EQ(windows[1].row, 2);
  EXPECT_EQ(windows[1].col, 2);
  EXPECT_EQ(windows[1].core.row0, 200);
}

}  // namespace
}  // namespace gable
