#include <gable/engine/io/raster/raster_mosaic.h>
#include <gable/engine/io/raster/raster_writer.h>

#include <cmath>
#include <limits>

#include "engine/io/scratch.h"

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Heights that tell every cell of the world from any other one, cells of 0.5 m.
HeightRaster ramp(double west, double north, int rows, int cols) {
  HeightRaster raster({{west, north}, 0.5, rows, cols}, 0.0f);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const Eigen::Vector2d at = raster.grid.center_of(row, col);
      raster.at(row, col) = static_cast<float>((at.x() - 1000.0) + 64.0 * (2000.0 - at.y()));
    }
  }
  return raster;
}

class RasterMosaicTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const HeightRaster& raster,
                    const std::string& crs = "EPSG:28992") const {
    write_raster(folder_.path(name), raster, crs_from_text(crs));
    return folder_.path(name);
  }

  ExitCode refused(const HeightRaster& second, const std::string& what,
                   const std::string& crs = "EPSG:28992") const {
    const std::string a = write("a.tif", ramp(1000.0, 2000.0, 4, 4));
    const std::string b = write("b.tif", second, crs);
    const Error error = error_of([&] { RasterMosaic({a, b}); }, b);
    EXPECT_THAT(error.what(), testing::HasSubstr(what));
    return error.code();
  }

  const ScratchFolder folder_;
};

TEST_F(RasterMosaicTest, TilesReadAsTheRasterThatTheyWereCutFrom) {
  const HeightRaster whole = ramp(1000.0, 2000.0, 20, 30);
  const RasterMosaic mosaic({write("se.tif", ramp(1005.0, 1995.0, 10, 20)),
                             write("nw.tif", ramp(1000.0, 2000.0, 10, 10)),
                             write("sw.tif", ramp(1000.0, 1995.0, 10, 10)),
                             write("ne.tif", ramp(1005.0, 2000.0, 10, 20))});
  EXPECT_EQ(mosaic.grid(), whole.grid);
  EXPECT_EQ(mosaic.crs().epsg, 28992);
  EXPECT_EQ(mosaic.read(0, 0, 20, 30).values, whole.values);
  const HeightRaster window = mosaic.read(8, 7, 5, 6);
  EXPECT_EQ(window.grid.north_west, Eigen::Vector2d(1003.5, 1996.0));
  for (int row = 0; row < 5; ++row) {
    for (int col = 0; col < 6; ++col) EXPECT_EQ(window.at(row, col), whole.at(row + 8, col + 7));
  }
}

TEST_F(RasterMosaicTest, CellsOfNoTileHaveNoHeightAndTilesSayWhereTheyAre) {
  const RasterMosaic mosaic(
      {write("a.tif", ramp(1000.0, 2000.0, 4, 4)), write("b.tif", ramp(1006.0, 1997.0, 4, 4))});
  EXPECT_EQ(mosaic.grid().rows, 10);
  EXPECT_EQ(mosaic.grid().cols, 16);
  const HeightRaster all = mosaic.read(0, 0, 10, 16);
  int num_heights = 0;
  for (const float z : all.values) num_heights += !std::isnan(z);
  EXPECT_EQ(num_heights, 32);
  ASSERT_EQ(mosaic.tiles().size(), 2u);
  EXPECT_EQ(mosaic.tiles()[1].north_west, Eigen::Vector2d(1006.0, 1997.0));
}

TEST_F(RasterMosaicTest, WhereTilesOverlapTheFirstHeightCounts) {
  HeightRaster first = ramp(1000.0, 2000.0, 4, 4);
  first.at(0, 3) = kNan;
  HeightRaster second = ramp(1001.0, 2000.0, 4, 4);
  for (float& z : second.values) z += 1000.0f;
  const RasterMosaic mosaic({write("a.tif", first), write("b.tif", second)});
  const HeightRaster row = mosaic.read(0, 0, 1, 6);
  EXPECT_EQ(row.values[2], first.at(0, 2));
  EXPECT_EQ(row.values[3], second.at(0, 1));
}

TEST_F(RasterMosaicTest, AnEmptyTileIsNoErrorUnlessAllAre) {
  const HeightRaster empty({{1002.0, 2000.0}, 0.5, 4, 4}, kNan);
  const std::string a = write("a.tif", ramp(1000.0, 2000.0, 4, 4)), b = write("b.tif", empty);
  EXPECT_EQ(RasterMosaic({b, a}).grid().cols, 8);
  EXPECT_EQ(error_of([&] { RasterMosaic({b, b}); }, b).code(), ExitCode::kBadInput);
}

TEST_F(RasterMosaicTest, TilesThatDoNotFitAreNamed) {
  EXPECT_EQ(refused(ramp(1002.25, 2000.0, 4, 4), "between those of"), ExitCode::kBadInput);
  HeightRaster fine = ramp(1002.0, 2000.0, 4, 4);
  fine.grid.gsd = 0.25;
  EXPECT_EQ(refused(fine, "cells of 0.25 m, but"), ExitCode::kBadInput);
  EXPECT_EQ(refused(ramp(1002.0, 2000.0, 4, 4), "-t_srs EPSG:28992", "EPSG:27700"),
            ExitCode::kBadInput);
  EXPECT_EQ(refused(ramp(1e12, 2000.0, 4, 4), "too far"), ExitCode::kBadInput);
}

TEST_F(RasterMosaicTest, MoreTilesThanMayBeOpenAreRead) {
  std::vector<std::string> paths;
  for (int i = 0; i < 70; ++i) {
    paths.push_back(write("t" + std::to_string(i) + ".tif", ramp(1000.0 + i, 2000.0, 2, 2)));
  }
  const RasterMosaic mosaic(paths);
  EXPECT_EQ(mosaic.read(0, 0, 2, 140).values, ramp(1000.0, 2000.0, 2, 140).values);
  EXPECT_EQ(mosaic.read(0, 0, 2, 140).values, ramp(1000.0, 2000.0, 2, 140).values);
}

}  // namespace
}  // namespace gable
