#include <gable/grammar/height_field.h>
#include <gable/grammar/polygon_cells.h>
#include <gable/grammar/synthesis/training_scene.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gable {
namespace {

constexpr Foundation kAll[] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                               Foundation::kL, Foundation::kU,  Foundation::kC};

bool same_bytes(const HeightRaster& a, const HeightRaster& b) {
  return a.grid == b.grid && a.values.size() == b.values.size() &&
         std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

TEST(TrainingScene, SameSeedGivesTheSameBytes) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    const TrainingScene a = make_training_scene(foundation, 7, options);
    const TrainingScene b = make_training_scene(foundation, 7, options);
    EXPECT_TRUE(same_bytes(a.dsm, b.dsm));
    EXPECT_TRUE(same_bytes(a.dtm, b.dtm));
    EXPECT_TRUE(same_bytes(a.truth, b.truth));
    EXPECT_FALSE(same_bytes(a.dsm, make_training_scene(foundation, 8, options).dsm));
  }
}

TEST(TrainingScene, TruthIsTheHeightFieldOfTheHouse) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    if (foundation == Foundation::kC) continue;
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      EXPECT_EQ(scene.house.foundation, foundation);
      EXPECT_TRUE(is_well_formed(scene.house));
      const HeightField field(scene.house);
      for (int row = 0; row < scene.truth.grid.rows; ++row) {
        for (int col = 0; col < scene.truth.grid.cols; ++col) {
          const Eigen::Vector2d local =
              scene.truth.grid.center_of(row, col) - scene.house.origin.head<2>();
          const float truth = scene.truth.at(row, col);
          if (field.block_at_house(field.house_from_local(local)) < 0) {
            EXPECT_TRUE(std::isnan(truth));
          } else {
            EXPECT_NEAR(truth, scene.house.origin.z() + field.at_local(local, 0.0, 0.0), 1e-4);
          }
        }
      }
    }
  }
}

TEST(TrainingScene, TheTerrainIsFiniteAndNearTheGroundEverywhere) {
  TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      options.terrain_error = 0.0;
      const TrainingScene exact = make_training_scene(foundation, seed, options);
      options.terrain_error = 0.4;
      ASSERT_EQ(scene.dtm.grid, exact.dtm.grid);
      for (size_t i = 0; i < scene.dtm.values.size(); ++i) {
        ASSERT_TRUE(std::isfinite(scene.dtm.values[i]));
        EXPECT_NEAR(scene.dtm.values[i], exact.dtm.values[i], 0.4 + 1e-4);
      }
    }
  }
}

TrainingSceneOptions no_defects() {
  TrainingSceneOptions options;
  options.neighbour_share = options.tree_share = options.garden_share = options.shed_share = 0.0;
  options.car_share = options.clutter_share = options.hole_share = options.smooth_share = 0.0;
  options.off_center_share = options.outlier_share = 0.0;
  options.row_share = options.oblique_share = options.torn_share = 0.0;
  options.plain_share = options.footprint_error = 0.0;
  options.least_noise = options.most_noise = options.terrain_error = 0.0;
  return options;
}

TEST(TrainingScene, WithoutDefectsTheSurveyIsTheBuildingOnItsTerrain) {
  const TrainingSceneOptions options = no_defects();
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      EXPECT_FALSE(scene.outline_needed);
      if (scene.outline.outer.empty()) continue;  // trees
      for (size_t i = 0; i < scene.dsm.values.size(); ++i) {
        const float truth = scene.truth.values[i];
        // Walls go down to the ground, and no roof lies below it.
        const float expected =
            std::isnan(truth) ? scene.dtm.values[i] : std::max(truth, scene.dtm.values[i]);
        EXPECT_NEAR(scene.dsm.values[i], expected, 1e-4);
      }
    }
  }
}

TEST(TrainingScene, OutlineIsWhereTheTruthIs) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      HeightRaster inside(scene.truth.grid, 0.0f);
      if (!scene.outline.outer.empty()) {
        for_cells_in_polygon(scene.outline, Eigen::Vector2d::Zero(), inside.grid,
                             [&](int row, int col) { inside.at(row, col) = 1.0f; });
      }
      int differ = 0, covered = 0;
      for (size_t i = 0; i < inside.values.size(); ++i) {
        covered += std::isfinite(scene.truth.values[i]);
        differ += std::isfinite(scene.truth.values[i]) != (inside.values[i] > 0.0f);
      }
      if (foundation != Foundation::kC) {
        EXPECT_LE(differ, 1);
      }
      // Things that stand apart have the outline of the largest.
      EXPECT_LE(differ, covered);
    }
  }
}

TEST(TrainingScene, RasterHasEightMetresOfSurroundings) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      const Grid& grid = scene.dsm.grid;
      EXPECT_EQ(scene.dtm.grid, grid);
      EXPECT_EQ(scene.truth.grid, grid);
      EXPECT_GE(grid.gsd, options.least_gsd);
      EXPECT_LE(grid.gsd, options.most_gsd);
      const Eigen::Vector2d south_east =
          grid.north_west + grid.gsd * Eigen::Vector2d(grid.cols, -grid.rows);
      double west = 1e9, east = 1e9, north = 1e9, south = 1e9;
      for (const Eigen::Vector2d& p : scene.outline.outer) {
        west = std::min(west, p.x() - grid.north_west.x());
        north = std::min(north, grid.north_west.y() - p.y());
        east = std::min(east, south_east.x() - p.x());
        south = std::min(south, p.y() - south_east.y());
      }
      if (scene.outline.outer.empty()) continue;
      for (double margin : {west, east, north, south}) {
        EXPECT_GE(margin, 8.0 - 1e-6);
        EXPECT_LE(margin, 8.0 + 2.0 * grid.gsd);
      }
    }
  }
}

TEST(TrainingScene, CentreIsOnTheBuilding) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      if (scene.outline.outer.empty()) {
        EXPECT_EQ(foundation, Foundation::kC);
        continue;
      }
      const Eigen::Vector2d cell = scene.truth.grid.cell_of(scene.center);
      EXPECT_TRUE(std::isfinite(scene.truth.at(static_cast<int>(std::lround(cell.x())),
                                               static_cast<int>(std::lround(cell.y())))));
    }
  }
}

TEST(TrainingScene, OutlineIsNeededWhereSomethingElseConnects) {
  TrainingSceneOptions options = no_defects();
  options.neighbour_share = 1.0;
  int needed = 0, wrong = 0;
  constexpr int kScenes = 150;
  for (int i = 0; i < kScenes; ++i) {
    const TrainingScene scene = make_training_scene(kAll[i % 5], i, options);
    needed += scene.outline_needed;
    // Cells of something else that is high beside cells of the house.
    bool joined = false;
    const Grid& grid = scene.dsm.grid;
    for (int row = 1; row < grid.rows; ++row) {
      for (int col = 1; col < grid.cols; ++col) {
        const auto is_other = [&](int r, int c) {
          return std::isnan(scene.truth.at(r, c)) && scene.dsm.at(r, c) > scene.dtm.at(r, c) + 2.0f;
        };
        const auto is_own = [&](int r, int c) { return std::isfinite(scene.truth.at(r, c)); };
        joined |= is_own(row, col) && (is_other(row - 1, col) || is_other(row, col - 1));
        joined |= is_other(row, col) && (is_own(row - 1, col) || is_own(row, col - 1));
      }
    }
    wrong += joined && !scene.outline_needed;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(needed, kScenes / 2);
  EXPECT_LT(needed, kScenes);
}

TEST(TrainingScene, OnlySurveysWithHolesMissCells) {
  TrainingSceneOptions options;
  int with_holes = 0;
  for (double share : {0.0, 1.0}) {
    options.hole_share = share;
    for (int seed = 0; seed < 40; ++seed) {
      const TrainingScene scene = make_training_scene(kAll[seed % 6], seed, options);
      bool missing = false;
      for (float height : scene.dsm.values) missing |= std::isnan(height);
      EXPECT_TRUE(share > 0.0 || !missing);
      with_holes += missing;
    }
  }
  EXPECT_GT(with_holes, 30);
}

TEST(TrainingScene, OneShareChangesNothingOfTheHouse) {
  const TrainingScene with = make_training_scene(Foundation::kU, 3, TrainingSceneOptions());
  const TrainingScene without = make_training_scene(Foundation::kU, 3, no_defects());
  EXPECT_TRUE(same_bytes(with.truth, without.truth));
}

double ring_area(const std::vector<Eigen::Vector2d>& ring) {
  double sum = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    sum += 0.5 * ((a.x() - ring[0].x()) * (b.y() - ring[0].y()) -
                  (a.y() - ring[0].y()) * (b.x() - ring[0].x()));
  }
  return sum;
}

TEST(TrainingScene, WithoutErrorsTheFootprintIsTheOutline) {
  const TrainingSceneOptions options = no_defects();
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const TrainingScene scene = make_training_scene(foundation, seed, options);
      ASSERT_EQ(scene.footprint.outer.size(), scene.outline.outer.size());
      for (size_t i = 0; i < scene.outline.outer.size(); ++i) {
        EXPECT_EQ(scene.footprint.outer[i], scene.outline.outer[i]);
      }
    }
  }
}

TEST(TrainingScene, FootprintsOfFoundationsLoseFifteenPerCentAtMost) {
  TrainingSceneOptions options;
  options.row_share = options.oblique_share = 1.0;
  int cut = 0;
  constexpr int kScenes = 150;
  for (int i = 0; i < kScenes; ++i) {
    const TrainingScene scene = make_training_scene(kAll[i % 3], i, options);
    const double kept = ring_area(scene.footprint.outer) / ring_area(scene.outline.outer);
    EXPECT_GE(kept, 0.85 - 1e-6);
    EXPECT_LE(kept, 1.0 + 1e-6);
    if (kept > 0.999) continue;
    ++cut;
    EXPECT_TRUE(scene.outline_needed);
  }
  EXPECT_GT(cut, kScenes / 4);
}

TEST(TrainingScene, TornSlicesLoseMore) {
  TrainingSceneOptions options;
  options.torn_share = 1.0;
  int torn = 0;
  for (int i = 0; i < 80; ++i) {
    const TrainingScene scene = make_training_scene(Foundation::kC, i, options);
    if (scene.outline.outer.empty()) continue;
    const double kept = ring_area(scene.footprint.outer) / ring_area(scene.outline.outer);
    if (kept > 0.999) continue;
    ++torn;
    EXPECT_LE(kept, 0.78 + 1e-6);
    EXPECT_GE(kept, 0.4 - 1e-6);
    EXPECT_TRUE(scene.outline_needed);
  }
  EXPECT_GT(torn, 30);
}

TEST(TrainingScene, RowsNeedOutlines) {
  TrainingSceneOptions options = no_defects();
  options.row_share = 1.0;
  options.most_gsd = 0.5;
  for (int i = 0; i < 40; ++i) {
    EXPECT_TRUE(
        make_training_scene(i % 2 ? Foundation::kI : Foundation::kII, i, options).outline_needed);
  }
}

TEST(TrainingScene, OptionsNameTheBoundThatDoesNotHold) {
  const auto check = [](auto set) {
    TrainingSceneOptions options;
    set(&options);
    return options.check();
  };
  EXPECT_EQ(TrainingSceneOptions().check(), "");
  EXPECT_EQ(check([](auto* o) { o->least_gsd = 0.05; }), "least_gsd must be in [0.1, 2]");
  EXPECT_EQ(check([](auto* o) { o->most_gsd = 0.2; }), "most_gsd must be in [least_gsd, 2]");
  EXPECT_EQ(check([](auto* o) { o->neighbour_share = NAN; }), "neighbour_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->tree_share = 1.1; }), "tree_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->car_share = -0.1; }), "car_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->hole_share = 2.0; }), "hole_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->smooth_share = 2.0; }), "smooth_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->garden_share = 2.0; }), "garden_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->shed_share = 2.0; }), "shed_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->clutter_share = 2.0; }), "clutter_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->outlier_share = 2.0; }), "outlier_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->off_center_share = -1.0; }),
            "off_center_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->most_noise = 3.0; }), "most_noise must be in [0, 2]");
  EXPECT_EQ(check([](auto* o) { o->least_noise = 0.5; }), "least_noise must be in [0, most_noise]");
  EXPECT_EQ(check([](auto* o) { o->terrain_error = 3.0; }), "terrain_error must be in [0, 2]");
  EXPECT_EQ(check([](auto* o) { o->row_share = 2.0; }), "row_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->oblique_share = 2.0; }), "oblique_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->plain_share = 2.0; }), "plain_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->gable_share = 2.0; }), "gable_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->bent_share = 2.0; }), "bent_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->torn_share = 2.0; }), "torn_share must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->least_hip_cells = 5.0; }), "least_hip_cells must be in [0, 4]");
  EXPECT_EQ(check([](auto* o) { o->footprint_error = 2.0; }), "footprint_error must be in [0, 1]");
  EXPECT_EQ(check([](auto* o) { o->prior.max_diagonal = 3.0; }), "max_diagonal must be >= 26");
}

}  // namespace
}  // namespace gable
