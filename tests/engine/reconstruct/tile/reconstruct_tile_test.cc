#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/survey/mean_cells.h>
#include <gable/grammar/synthesis/terrace.h>
#include <gable/grammar/synthesis/village.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "engine/detectors/tiny_nets.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

class ReconstructTile : public testing::Test {
 protected:
  ReconstructTile() {
    VillageOptions options;
    options.count = 6;
    options.seed = 3;
    village_ = synthesize_village(options);
    const Crs crs = crs_from_text("EPSG:27700");
    write_raster(folder_.path("dsm.tif"), village_.dsm, crs);
    write_raster(folder_.path("dtm.tif"), village_.dtm, crs);
    for (size_t i = 0; i < village_.footprints.size(); ++i) {
      footprints_.push_back({std::to_string(i), village_.footprints[i]});
    }
  }

  /// All buildings, sorted by id.
  std::vector<Building> reconstruct(bool outlined, int window_cells) {
    const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
    TileOptions options;
    options.window_cells = window_cells;
    options.overlap = 40.0;
    std::vector<Building> buildings;
    TileCallbacks callbacks;
    int windows = 0;
    callbacks.begin_window = [&](int, int num_windows, size_t) { windows = num_windows; };
    callbacks.deliver = [&](TileBuilding&& made) {
      EXPECT_EQ(made.index, buildings.size());
      buildings.push_back(std::move(made.building));
    };
    const TileSummary summary = reconstruct_tile(
        {&dsm, &dtm, outlined ? &footprints_ : nullptr, nullptr}, options, {}, callbacks);
    EXPECT_EQ(summary.num_buildings, buildings.size());
    EXPECT_EQ(windows > 1, window_cells < 1000);
    std::sort(buildings.begin(), buildings.end(),
              [](const Building& a, const Building& b) { return a.id < b.id; });
    return buildings;
  }

  /// The same buildings, whatever windows they were found in.
  void expect_same_in_windows(bool outlined) {
    const std::vector<Building> whole = reconstruct(outlined, 8192);
    const std::vector<Building> parts = reconstruct(outlined, 100);
    ASSERT_EQ(whole.size(), village_.houses.size());
    ASSERT_EQ(parts.size(), whole.size());
    for (size_t i = 0; i < whole.size(); ++i) {
      EXPECT_EQ(parts[i].id, whole[i].id);
      ASSERT_EQ(parts[i].house.has_value(), whole[i].house.has_value());
      EXPECT_NEAR(parts[i].quality.mad, whole[i].quality.mad, 1e-3) << whole[i].id;
    }
  }

  const ScratchFolder folder_;
  Village village_;
  std::vector<Footprint> footprints_;
};

TEST_F(ReconstructTile, WindowsDoNotChangeWhatIsFound) { expect_same_in_windows(false); }

TEST_F(ReconstructTile, WindowsDoNotChangeWhatIsMadeOfFootprints) { expect_same_in_windows(true); }

TEST_F(ReconstructTile, WhatIsNoBuildingAfterAllIsCountedAndNotDelivered) {
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
  std::vector<size_t> indices;
  TileCallbacks callbacks;
  callbacks.inspect = [](const TileBuilding& made) { EXPECT_TRUE(made.is_building); };
  callbacks.deliver = [&](TileBuilding&& made) { indices.push_back(made.index); };
  int asked = 0;
  const TileSummary summary =
      visit_tile({&dsm, &dtm, nullptr, nullptr}, TileOptions{}, {}, callbacks,
                 [&](const std::string&, const PlanPolygon*, TileBuilding* building) {
                   building->is_building = asked++ % 3 != 1;
                 });
  ASSERT_EQ(asked, 6);
  EXPECT_EQ(summary.num_buildings, 4u);
  EXPECT_EQ(summary.num_unexplained, 2);
  EXPECT_EQ(indices, (std::vector<size_t>{0, 2, 3, 5}));
}

TEST(SmallPieces, AHedgeIsNoBuildingAndAHouseAsSmallIsOne) {
  const Grid grid{{500000.0, 200060.0}, 0.5, 120, 120};
  const Crs crs = crs_from_text("EPSG:27700");
  // A hedge round the corner of a garden, 2.5 m wide and 19 m long, clipped by nobody.
  const Eigen::Vector2d corner = grid.center_of(90, 30);
  // A gable roof of 10 x 6 m.
  const Eigen::Vector2d middle = grid.center_of(40, 80);
  HeightRaster heights(grid, 0.0f);
  Random random(4);
  int hedge_cells = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const Eigen::Vector2d p = grid.center_of(row, col);
      const double radius = (p - corner).norm();
      const Eigen::Vector2d q = (p - middle).cwiseAbs();
      double height = random.normal(0.03);
      if (p.x() > corner.x() && p.y() > corner.y() && radius > 11.0 && radius < 13.5) {
        ++hedge_cells;
        height = 3.0 + 0.8 * std::sin(radius * 2.5) * std::sin(p.x() * 0.9) + random.normal(0.1);
      } else if (q.x() < 5.0 && q.y() < 3.0) {
        height = 6.0 - 0.7 * q.y() + random.normal(0.03);
      }
      heights.at(row, col) = static_cast<float>(height);
    }
  }
  const double hedge_area = hedge_cells * grid.gsd * grid.gsd;
  ASSERT_GT(hedge_area, 40.0);
  ASSERT_LT(hedge_area, 60.0);
  const ScratchFolder folder;
  write_raster(folder.path("dsm.tif"), heights, crs);
  write_raster(folder.path("dtm.tif"), HeightRaster(grid, 0.0f), crs);
  const RasterFile dsm(folder.path("dsm.tif")), dtm(folder.path("dtm.tif"));
  std::vector<Building> buildings;
  TileCallbacks callbacks;
  callbacks.deliver = [&](TileBuilding&& made) { buildings.push_back(std::move(made.building)); };
  TileOptions options;
  const auto run = [&] {
    buildings.clear();
    return reconstruct_tile({&dsm, &dtm, nullptr, nullptr}, options, {}, callbacks);
  };
  TileSummary summary = run();
  EXPECT_EQ(summary.num_unexplained, 1);
  ASSERT_EQ(buildings.size(), 1u);
  EXPECT_EQ(buildings[0].status, BuildingStatus::kGrammar);
  EXPECT_LT((buildings[0].house->origin.head<2>() - middle).norm(), 8.0) << "the house stays";
  options.least_unexplained_area = 0.0;
  summary = run();
  EXPECT_EQ(summary.num_unexplained, 0);
  EXPECT_EQ(buildings.size(), 2u);
  // Whatever has an outline is a building.
  options.least_unexplained_area = 1e6;
  const Eigen::Vector2d a = corner, b = corner + Eigen::Vector2d::Constant(14.0);
  const std::vector<Footprint> outlines = {{"hedge", {{a, {b.x(), a.y()}, b, {a.x(), b.y()}}, {}}}};
  summary = reconstruct_tile({&dsm, &dtm, &outlines, nullptr}, options, {}, callbacks);
  EXPECT_EQ(summary.num_buildings, 1u);
  EXPECT_EQ(summary.num_unexplained, 0);
  options.least_unexplained_area = -1.0;
  EXPECT_EQ(check(options), "least_unexplained_area must lie in [0, 1e6] square metres");
}

// Mean distance of two houses' heights over the plan of the second, metres; a miss counts as the
// second's origin.
double mean_distance(const House& found, const House& truth) {
  const HeightField field(found), true_field(truth);
  double sum = 0.0;
  int count = 0;
  for (double x = -15.0; x < 15.0; x += 0.25) {
    for (double y = -15.0; y < 15.0; y += 0.25) {
      const Eigen::Vector2d p(x, y);
      if (true_field.block_at_house(true_field.house_from_local(p)) < 0) continue;
      const Eigen::Vector3d shift = truth.origin - found.origin;
      const double height = field.at_local(p + shift.head<2>(), 0.0, shift.z()) - shift.z();
      sum += std::abs(height - true_field.at_local(p, 0.0, 0.0));
      ++count;
    }
  }
  return sum / count;
}

TEST(MeanHeights, AreToldByTheirWallsAndHousesAreNearTheTruthInMetreCells) {
  VillageOptions village_options;
  village_options.count = 24;
  village_options.seed = 5;
  village_options.gsd = 0.25;
  village_options.trees_per_house = 0.0;
  village_options.touching_trees = 0.0;
  const Village village = synthesize_village(village_options);
  const Crs crs = crs_from_text("EPSG:27700");
  const ScratchFolder folder;
  write_raster(folder.path("dsm.tif"), mean_cells(village.dsm, 4, CellMeans::kOver), crs);
  write_raster(folder.path("dtm.tif"), mean_cells(village.dtm, 4, CellMeans::kOver), crs);
  const RasterFile dsm(folder.path("dsm.tif")), dtm(folder.path("dtm.tif"));
  // The median over the houses.
  const auto distance_from_truth = [&](std::optional<double> spread, double* told) {
    TileOptions options;
    options.crop.spread = spread;
    TileCallbacks callbacks;
    std::vector<double> distances;
    callbacks.deliver = [&](TileBuilding&& made) {
      EXPECT_EQ(made.image.spread > 0.0, spread != 0.0);
      if (!made.building.house) return;
      const House& found = *made.building.house;
      const House* nearest = nullptr;
      double least = 6.0;
      for (const House& house : village.houses) {
        const double distance = (house.origin - found.origin).head<2>().norm();
        if (distance < least) least = distance, nearest = &house;
      }
      if (nearest) distances.push_back(mean_distance(found, *nearest));
    };
    const TileSummary summary =
        reconstruct_tile({&dsm, &dtm, nullptr, nullptr}, options, {}, callbacks);
    *told = summary.spread;
    EXPECT_GE(distances.size(), 20u);
    std::sort(distances.begin(), distances.end());
    return distances[distances.size() / 2];
  };
  double told = 0.0;
  const double distance = distance_from_truth({}, &told);
  EXPECT_NEAR(told, 1.0, 0.2);
  const double as_points = distance_from_truth(0.0, &told);
  EXPECT_EQ(told, 0.0);
  EXPECT_LT(distance, 0.2);
  EXPECT_GT(as_points, 2.0 * distance);
  TileOptions options;
  options.crop.spread = -1.0;
  EXPECT_EQ(check(options), "spread must lie in [0, 100] m");
}

TEST_F(ReconstructTile, WithDetectorsThreadsChangeNothing) {
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
  write_tiny_nets(folder_);
  TileOptions options;
  options.detectors = folder_.path("");
  const auto choices = [&](int threads) {
    options.threads = threads;
    std::vector<HouseChoice> made;
    TileCallbacks callbacks;
    callbacks.deliver = [&](TileBuilding&& b) { made.push_back(std::move(b.choice)); };
    reconstruct_tile({&dsm, &dtm, &footprints_, nullptr}, options, {}, callbacks);
    return made;
  };
  const std::vector<HouseChoice> one = choices(1), three = choices(3);
  ASSERT_EQ(one.size(), footprints_.size());
  ASSERT_EQ(three.size(), one.size());
  for (size_t i = 0; i < one.size(); ++i) {
    ASSERT_TRUE(one[i].foundation.has_value());
    EXPECT_EQ(*one[i].foundation, *three[i].foundation);
    EXPECT_EQ(one[i].num_hypotheses(), three[i].num_hypotheses());
    EXPECT_EQ(one[i].best.cost.total, three[i].best.cost.total);
    EXPECT_EQ(one[i].best.source, three[i].best.source);
  }
}

TEST_F(ReconstructTile, DetectorsThatAreMissingAreKnownBeforeAnyWork) {
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
  TileOptions options;
  options.detectors = folder_.path("nowhere");
  TileCallbacks callbacks;
  callbacks.begin_window = [](int, int, size_t) { ADD_FAILURE() << "work was begun"; };
  const Error error = error_of(
      [&] {
        reconstruct_tile({&dsm, &dtm, nullptr, nullptr}, options, {}, callbacks);
      },
      "nowhere");
  EXPECT_EQ(error.code(), ExitCode::kNoInput);
}

TEST_F(ReconstructTile, AFootprintWithoutHeightsComesOutWithTheReason) {
  const Eigen::Vector2d corner = village_.dsm.grid.north_west;
  for (float& z : village_.dsm.values) {
    if (&z < &village_.dsm.values[village_.dsm.grid.cols * 20]) z = NAN;  // the northern 10 m
  }
  write_raster(folder_.path("dsm.tif"), village_.dsm, crs_from_text("EPSG:27700"));
  const Eigen::Vector2d a = corner + Eigen::Vector2d(20.0, -8.0);
  footprints_ = {
      {"bare",
       {{a, a + Eigen::Vector2d(6, 0), a + Eigen::Vector2d(6, 6), a + Eigen::Vector2d(0, 6)}, {}}}};
  const std::vector<Building> buildings = reconstruct(true, 8192);
  ASSERT_EQ(buildings.size(), 1u);
  EXPECT_EQ(buildings[0].status, BuildingStatus::kExtrusion);
  EXPECT_NE(buildings[0].reason.find("0.0 square metres with heights"), std::string::npos);
  EXPECT_GT(buildings[0].height, buildings[0].base);
}

// A row of three houses with their footprints.
class ReconstructTerrace : public testing::Test {
 protected:
  ReconstructTerrace() {
    TerraceOptions options;
    options.count = 3;
    options.seed = 5;
    const Terrace terrace = make_terrace(options);
    const Crs crs = crs_from_text("EPSG:27700");
    write_raster(folder_.path("dsm.tif"), terrace.dsm, crs);
    write_raster(folder_.path("dtm.tif"), terrace.dtm, crs);
    for (size_t i = 0; i < terrace.footprints.size(); ++i) {
      footprints_.push_back({std::to_string(i), terrace.footprints[i]});
    }
  }

  std::vector<TileBuilding> reconstruct(bool join, int threads) {
    TileOptions options;
    options.join_neighbours = join;
    options.threads = threads;
    std::vector<TileBuilding> buildings;
    TileCallbacks callbacks;
    callbacks.made = [&] { ++num_made_; };
    callbacks.deliver = [&](TileBuilding&& made) {
      EXPECT_EQ(made.index, buildings.size());
      buildings.push_back(std::move(made));
      if (buildings.size() == 1) num_made_at_first_ = num_made_;
    };
    num_made_ = 0;
    const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
    reconstruct_tile({&dsm, &dtm, &footprints_, nullptr}, options, {}, callbacks);
    return buildings;
  }

  const ScratchFolder folder_;
  std::vector<Footprint> footprints_;
  int num_made_ = 0, num_made_at_first_ = 0;
};

TEST_F(ReconstructTerrace, NeighboursAreRefinedTogetherUnlessLeftAlone) {
  const std::vector<TileBuilding> alone = reconstruct(false, 1);
  EXPECT_EQ(num_made_at_first_, 1);
  const std::vector<TileBuilding> one = reconstruct(true, 1), three = reconstruct(true, 3);
  EXPECT_EQ(num_made_at_first_, 3);
  EXPECT_EQ(num_made_, 3);
  ASSERT_EQ(alone.size(), 3u);
  ASSERT_EQ(one.size(), 3u);
  int related = 0;
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(alone[i].relations.empty());
    related += !one[i].relations.empty();
    ASSERT_TRUE(one[i].building.house && three[i].building.house);
    const auto a = std::as_const(*one[i].building.house).derivation();
    const auto b = std::as_const(*three[i].building.house).derivation();
    ASSERT_EQ(a.size(), b.size());
    for (size_t r = 0; r < a.size(); ++r) EXPECT_EQ(a[r]->values, b[r]->values);
    EXPECT_LT(one[i].building.quality.mad, alone[i].building.quality.mad + 0.02);
  }
  // One that came out as another type may share nothing.
  EXPECT_GE(related, 2);
}

TEST_F(ReconstructTerrace, AnInterruptedWindowDeliversNothing) {
  std::stop_source stop;
  TileCallbacks callbacks;
  callbacks.made = [&] { stop.request_stop(); };
  callbacks.deliver = [](TileBuilding&&) { ADD_FAILURE() << "delivered"; };
  const RasterFile dsm(folder_.path("dsm.tif")), dtm(folder_.path("dtm.tif"));
  const TileSummary summary = reconstruct_tile({&dsm, &dtm, &footprints_, nullptr}, TileOptions{},
                                               stop.get_token(), callbacks);
  EXPECT_TRUE(summary.stopped);
  EXPECT_EQ(summary.num_buildings, 0u);
}

}  // namespace
}  // namespace gable
