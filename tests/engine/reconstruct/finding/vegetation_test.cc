#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/grammar/synthesis/ground/vegetation.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/house_image.h"

namespace gable {
namespace {

int count(const std::vector<unsigned char>& marks) {
  return static_cast<int>(std::count(marks.begin(), marks.end(), 1));
}

TEST(Vegetation, MostOfTheTreesCrownsAreFound) {
  int crown = 0, found = 0, roof = 0, wrong = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SceneOptions options;
    options.seed = seed;
    options.trees = 3;
    const Scene scene = make_scene(Foundation::kI, options);
    const HeightImage image = image_of(scene);
    const std::vector<unsigned char> marks = find_vegetation(image, {});
    for (int row = 0; row < image.rows; ++row) {
      for (int col = 0; col < image.cols; ++col) {
        const size_t i = image.index(row, col);
        const bool house = scene.truth.values[i] - scene.dtm.values[i] > 1.0f;
        const Eigen::Vector2d p = scene.dsm.grid.center_of(row, col);
        const bool under_tree =
            std::any_of(scene.trees.begin(), scene.trees.end(),
                        [&](const Tree& t) { return (t.center - p).norm() < 0.9 * t.radius; });
        const bool near_tree =
            std::any_of(scene.trees.begin(), scene.trees.end(),
                        [&](const Tree& t) { return (t.center - p).norm() < t.radius + 2.0; });
        if (under_tree && !house && image.height[i] - image.ground[i] > 1.0f) {
          ++crown;
          found += marks[i];
        }
        if (house && !near_tree) {
          ++roof;
          wrong += marks[i];
        }
      }
    }
  }
  EXPECT_GT(crown, 1000);
  EXPECT_GE(found, 0.78 * crown);
  EXPECT_LE(wrong, 0.002 * roof);
}

// Roofs with everything that may stand on them.
std::vector<House> roofs() {
  House dormers = box_house(12.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), 0.3);
  for (const double x : {-3.0, 2.5}) {
    Rule dormer = make_rule(RuleKind::kDormer);
    dormer.component = 0;
    dormer.values = {x, -2.4, 2.2, 2.4, 6.4, 0.6};
    dormers.dormers.push_back(dormer);
  }
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {4.5, 0.0, 0.8, 9.5};
  dormers.chimneys = {chimney};
  House steps = make_house(Foundation::kII);
  steps.azimuth[0] = 0.7;
  steps.footprints = {rectangle_rule(-8.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 8.0, -3.0, 3.0)};
  steps.roofs = {hip_roof(6.0, 2.5, 0.3, 0.3, Axis::kX), gable_roof(4.0, 2.0, Axis::kX)};
  return {box_house(12.0, 8.0, gable_roof(5.0, 3.0, Axis::kX), 0.3),
          box_house(12.0, 8.0, hip_roof(5.0, 4.0, 0.33, 0.33, Axis::kX), 1.0),
          box_house(12.0, 8.0, flat_roof(5.0), 0.5), dormers, steps};
}

TEST(Vegetation, NoPixelOfARoofIsMarkedWithoutNoise) {
  for (const House& house : roofs()) {
    EXPECT_EQ(count(find_vegetation(image_of(house), {})), 0);
    EXPECT_EQ(count(find_vegetation(image_of(house, {.gsd = 0.25, .size = 128}), {})), 0);
  }
}

TEST(Vegetation, NoPixelOfARoofIsMarkedUnderSurveyNoise) {
  SceneOptions options;
  options.trees = 0;
  for (const House& house : roofs()) {
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      options.seed = seed;
      EXPECT_EQ(count(find_vegetation(image_of(make_scene(house, options)), {})), 0)
          << "seed " << seed;
    }
  }
}

TEST(Vegetation, NarrowSteepRoofsAreNoCrownsThoughEveryNeighbourhoodHoldsARidge) {
  VegetationOptions options = vegetation_at({}, 1.0);
  int rough = 0;
  for (const double azimuth : {0.0, 0.3, 0.6}) {
    for (const double width : {5.0, 6.0, 7.0}) {
      const House house = box_house(14.0, width, gable_roof(4.5, 0.7 * width, Axis::kX), azimuth);
      options.least_contrast = vegetation_at({}, 1.0).least_contrast;
      EXPECT_EQ(count(find_vegetation(image_of(house, {.gsd = 1.0, .size = 40}), options)), 0)
          << azimuth << ' ' << width;
      options.least_contrast = 1.0;
      rough += count(find_vegetation(image_of(house, {.gsd = 1.0, .size = 40}), options));
    }
  }
  EXPECT_GT(rough, 0);  // they are rough: only how much tells them from crowns
}

TEST(Vegetation, SetAsideMakesBareGroundOfLittleWeight) {
  HeightImage image = image_of(box_house(12.0, 8.0, flat_roof(5.0)));
  const HeightImage before = image;
  const size_t pixel = image.index(32, 32);
  image.ground[pixel] = 0.7f;
  set_aside(pixel, &image);
  EXPECT_EQ(image.height[pixel], 0.7f);
  EXPECT_GT(image.weight[pixel], 0.0f);
  EXPECT_FALSE(is_evidence(image, pixel));
  EXPECT_EQ(image.inside[pixel], before.inside[pixel]);
  for (size_t i = 0; i < image.size(); ++i) {
    if (i == pixel) continue;
    ASSERT_EQ(image.height[i], before.height[i]);
    ASSERT_EQ(image.weight[i], before.weight[i]);
  }
}

TEST(Vegetation, LeavingOutSetsExactlyTheFoundPixelsAside) {
  SceneOptions options;
  options.seed = 3;
  options.trees = 3;
  HeightImage image = image_of(make_scene(Foundation::kI, options));
  const HeightImage before = image;
  const std::vector<unsigned char> marks = find_vegetation(image, {});
  EXPECT_EQ(leave_out_vegetation({}, &image), count(marks));
  EXPECT_GT(count(marks), 0);
  for (size_t i = 0; i < image.size(); ++i) {
    ASSERT_EQ(is_evidence(image, i), !marks[i]);
    ASSERT_EQ(image.inside[i], marks[i] ? 0 : before.inside[i]);
    ASSERT_EQ(image.height[i], marks[i] ? before.ground[i] : before.height[i]);
  }
}

}  // namespace
}  // namespace gable
