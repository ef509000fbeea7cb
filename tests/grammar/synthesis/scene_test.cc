#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/scene.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

TEST(Scene, SameSeedGivesTheSameHeights) {
  SceneOptions options;
  options.seed = 9;
  options.trees = 3;
  options.lidar.outlier_share = 0.03;
  const Scene a = make_scene(Foundation::kL, options), b = make_scene(Foundation::kL, options);
  EXPECT_EQ(a.dsm.values, b.dsm.values);
  EXPECT_EQ(a.truth.values, b.truth.values);
  options.seed = 10;
  EXPECT_NE(make_scene(Foundation::kL, options).dsm.values, a.dsm.values);
}

TEST(Scene, TruthIsTheTerrainAndTheHouseAlone) {
  SceneOptions options;
  options.trees = 2;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    options.seed = seed;
    const Scene scene = make_scene(Foundation::kIII, options);
    const HeightField field(scene.house);
    for (int row = 0; row < options.size; ++row) {
      for (int col = 0; col < options.size; ++col) {
        const Eigen::Vector2d local =
            scene.dtm.grid.center_of(row, col) - scene.house.origin.head<2>();
        const double ground = scene.dtm.at(row, col) - scene.house.origin.z();
        EXPECT_NEAR(scene.truth.at(row, col),
                    scene.house.origin.z() + field.at_local(local, 0.0, ground), 1e-4);
      }
    }
  }
}

TEST(Scene, WithoutTreesAndNoiseTheSurveyIsTheTruth) {
  SceneOptions options;
  options.trees = 0;
  options.lidar.noise_share = 0.0;
  const Scene scene = make_scene(Foundation::kU, options);
  EXPECT_EQ(scene.dsm.values, scene.truth.values);
}

TEST(Scene, HouseLiesWithinTheCrop) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    SceneOptions options;
    options.seed = seed;
    const Scene scene = make_scene(Foundation::kU, options);
    for (int i = 0; i < options.size; ++i) {
      for (auto [row, col] : {std::pair(0, i), std::pair(options.size - 1, i), std::pair(i, 0),
                              std::pair(i, options.size - 1)}) {
        EXPECT_EQ(scene.truth.at(row, col), scene.dtm.at(row, col)) << "seed " << seed;
      }
    }
  }
}

TEST(Scene, TreesAreRoughAndReachTheHouse) {
  int covered = 0;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    SceneOptions options;
    options.seed = seed;
    options.trees = 2;
    options.lidar.noise_share = 0.0;
    const Scene scene = make_scene(Foundation::kI, options);
    double raised = 0.0;
    for (size_t i = 0; i < scene.dsm.values.size(); ++i) {
      EXPECT_GE(scene.dsm.values[i], scene.truth.values[i]);
      if (scene.dsm.values[i] > scene.truth.values[i]) ++raised;
      if (scene.dsm.values[i] > scene.truth.values[i] &&
          scene.truth.values[i] > scene.dtm.values[i]) {
        ++covered;
      }
    }
    EXPECT_GT(raised, 20);
  }
  EXPECT_GT(covered, 0);
}

}  // namespace
}  // namespace gable
