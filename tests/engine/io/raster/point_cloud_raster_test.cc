#include <gable/engine/io/raster/point_cloud_raster.h>

#include <cmath>
#include <map>
#include <random>

#include "engine/io/scans/sample_files.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

struct ClassedPoint {
  Eigen::Vector3d at;
  int classification;
};

class PointCloudRasterTest : public testing::Test {
 protected:
  PointCloudRasterTest() {
    options_.crs = "EPSG:28992";
    options_.scratch = folder_.path("");
  }

  std::string write(const std::string& name, const std::vector<ClassedPoint>& points,
                    int format = 1) const {
    Scan scan;
    for (const ClassedPoint& point : points) {
      scan.points.push_back(point.at);
      scan.labels["plane"].push_back(point.classification);
    }
    return folder_.write(name, las_file(scan, format < 6 ? 2 : 4, format));
  }

  static float at(const HeightSource& source, double x, double y) {
    const Eigen::Vector2d cell = source.grid().cell_of({x, y});
    return source
        .read(static_cast<int>(std::lround(cell.x())), static_cast<int>(std::lround(cell.y())), 1,
              1)
        .values[0];
  }

  const ScratchFolder folder_;
  PointCloudRasterOptions options_;
};

TEST_F(PointCloudRasterTest, ACellIsItsHighestPointAndItsLowestGround) {
  const std::string path = write("a.las", {{{100.25, 200.25, 3.0}, 1},
                                           {{100.25, 200.25, 5.0}, 1},
                                           {{100.25, 200.25, 1.0}, 2},
                                           {{100.25, 200.25, 0.5}, 2},
                                           {{103.25, 203.25, 9.0}, 1}});
  const PointCloudRaster raster = rasterise_point_clouds({path}, options_);
  EXPECT_EQ(raster.dsm->grid().north_west, Eigen::Vector2d(100.0, 203.5));
  EXPECT_EQ(raster.dsm->grid().rows, 7);
  EXPECT_EQ(raster.dsm->grid().cols, 7);
  EXPECT_EQ(raster.dsm->crs().epsg, 28992);
  EXPECT_EQ(at(*raster.dsm, 100.25, 200.25), 5.0f);
  ASSERT_NE(raster.dtm, nullptr);
  EXPECT_EQ(at(*raster.dtm, 100.25, 200.25), 0.5f);
  EXPECT_TRUE(std::isnan(at(*raster.dtm, 103.25, 203.25)));
  EXPECT_NE(raster.used.find("all classes but noise"), std::string::npos) << raster.used;
}

TEST_F(PointCloudRasterTest, WhereBuildingsAreMarkedTreesAreLeftOutAndNoiseAlways) {
  std::vector<ClassedPoint> points = {{{100.25, 200.25, 1.0}, 2},  {{100.25, 200.25, 20.0}, 5},
                                      {{100.25, 200.25, 99.0}, 7}, {{103.25, 200.25, 8.0}, 1},
                                      {{106.25, 200.25, 0.0}, 9},  {{106.25, 200.25, 90.0}, 18}};
  const PointCloudRaster all = rasterise_point_clouds({write("a.las", points)}, options_);
  EXPECT_EQ(at(*all.dsm, 100.25, 200.25), 20.0f);
  EXPECT_EQ(at(*all.dsm, 103.25, 200.25), 8.0f);
  EXPECT_EQ(at(*all.dsm, 106.25, 200.25), 0.0f);
  EXPECT_EQ(all.num_used, 4u);
  points.push_back({{109.25, 200.25, 6.0}, 6});
  const PointCloudRaster some = rasterise_point_clouds({write("b.las", points)}, options_);
  EXPECT_EQ(at(*some.dsm, 100.25, 200.25), 1.0f);
  EXPECT_TRUE(std::isnan(at(*some.dsm, 103.25, 200.25)));
  EXPECT_EQ(at(*some.dsm, 106.25, 200.25), 0.0f);
  EXPECT_EQ(at(*some.dsm, 109.25, 200.25), 6.0f);
  EXPECT_EQ(some.num_used, 3u);
}

TEST_F(PointCloudRasterTest, WithoutGroundInEveryFileThereIsNoTerrain) {
  const std::string a = write("a.las", {{{100.25, 200.25, 1.0}, 2}});
  const std::string b = write("b.las", {{{110.25, 200.25, 1.0}, 1}});
  EXPECT_NE(rasterise_point_clouds({a}, options_).dtm, nullptr);
  EXPECT_EQ(rasterise_point_clouds({a, b}, options_).dtm, nullptr);
}

TEST_F(PointCloudRasterTest, FilesInAnyOrderAndCutGiveWhatOneGives) {
  std::mt19937 random(5);  // its bits are the same everywhere
  std::vector<ClassedPoint> points, west, east;
  for (int i = 0; i < 4000; ++i) {
    const double x = 100.0 + 0.25 * (random() % 160), y = 200.0 + 0.25 * (random() % 120);
    const ClassedPoint point{{x, y, 0.25 * (random() % 40)}, i % 3 ? 6 : 2};
    points.push_back(point);
    (x <= 120.0 ? west : east).push_back(point);  // 120 is a line between cells
  }
  options_.gsd = 1.0;
  const PointCloudRaster one = rasterise_point_clouds({write("all.las", points)}, options_);
  const std::string w = write("w.las", west, 6), e = write("e.las", east);
  // What each cell must be, the plain way.
  std::map<std::pair<long, long>, double> highest;
  for (const ClassedPoint& point : points) {
    const auto cell =
        std::pair(std::lround(std::floor(point.at.x())), std::lround(std::floor(point.at.y())));
    const auto [place, is_new] = highest.emplace(cell, point.at.z());
    if (!is_new) place->second = std::max(place->second, point.at.z());
  }
  for (const auto& [cell, height] : highest) {
    EXPECT_EQ(
        at(*one.dsm, static_cast<double>(cell.first) + 0.5, static_cast<double>(cell.second) + 0.5),
        static_cast<float>(height));
  }
  for (const auto& paths : {std::vector{w, e}, std::vector{e, w}}) {
    const PointCloudRaster two = rasterise_point_clouds(paths, options_);
    const Grid& grid = one.dsm->grid();
    ASSERT_EQ(two.dsm->grid(), grid);
    const HeightRaster a = one.dsm->read(0, 0, grid.rows, grid.cols);
    const HeightRaster b = two.dsm->read(0, 0, grid.rows, grid.cols);
    for (size_t i = 0; i < a.values.size(); ++i) {
      EXPECT_TRUE(a.values[i] == b.values[i] ||
                  (std::isnan(a.values[i]) && std::isnan(b.values[i])));
    }
    EXPECT_EQ(two.dsm->tiles().size(), 2u);
  }
}

TEST_F(PointCloudRasterTest, SparsePointsOnASlopeLeaveNoNarrowGap) {
  std::vector<ClassedPoint> points;
  for (int i = 0; i < 600; ++i) {  // more rows than are filled in one go
    for (int j = 0; j < 10; ++j) points.push_back({{100.25 + j, 200.25 + i, 0.25 * j}, 1});
  }
  const PointCloudRaster raster = rasterise_point_clouds({write("a.las", points)}, options_);
  const Grid& grid = raster.dsm->grid();
  const HeightRaster heights = raster.dsm->read(0, 0, grid.rows, grid.cols);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      EXPECT_FLOAT_EQ(heights.at(row, col), 0.125f * static_cast<float>(col)) << row << " " << col;
    }
  }
}

TEST_F(PointCloudRasterTest, WhatCannotBeUsedIsNamed) {
  const std::string a = write("a.las", {{{100.25, 200.25, 1.0}, 2}});
  const std::string noise = write("noise.las", {{{100.25, 200.25, 1.0}, 7}});
  const std::string none = folder_.path("none.las"), text = folder_.write("text.las", "text");
  const auto refused = [&](const std::string& path, const std::string& crs) {
    options_.crs = crs;
    return error_of([&] { rasterise_point_clouds({path}, options_); }, path).code();
  };
  EXPECT_EQ(refused(a, ""), ExitCode::kBadInput);
  EXPECT_EQ(refused(a, "EPSG:4326"), ExitCode::kBadInput);
  EXPECT_EQ(refused(noise, "EPSG:28992"), ExitCode::kBadInput);
  EXPECT_EQ(refused(text, "EPSG:28992"), ExitCode::kBadInput);
  EXPECT_EQ(refused(none, "EPSG:28992"), ExitCode::kNoInput);
}

TEST(IsPointCloud, GoesByTheExtension) {
  EXPECT_TRUE(is_point_cloud("a/b.LAZ"));
  EXPECT_TRUE(is_point_cloud("b.las"));
  EXPECT_FALSE(is_point_cloud("las.tif"));
}

}  // namespace
}  // namespace gable
