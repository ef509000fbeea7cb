#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/training_scene.h>
#include <gtest/gtest.h>

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

TEST(TrainingScene, TheTerrainIsFiniteEverywhere) {
  const TrainingSceneOptions options;
  for (Foundation foundation : kAll) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      for (float height : make_training_scene(foundation, seed, options).dtm.values) {
        ASSERT_TRUE(std::isfinite(height));
      }
    }
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
  EXPECT_EQ(check([](auto* o) { o->terrain_error = 3.0; }), "terrain_error must be in [0, 2]");
  EXPECT_EQ(check([](auto* o) { o->prior.max_diagonal = 3.0; }), "max_diagonal must be >= 26");
}

}  // namespace
}  // namespace gable
